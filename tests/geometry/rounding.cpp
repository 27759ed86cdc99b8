#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/geometry/rounding.hpp>
#include <tencer/geometry/sampling.hpp>

using namespace tencer::geometry;
using std::numbers::pi;

namespace {

Polyline polygon(std::vector<Eigen::Vector3d> corners, bool closed) {
  Polyline curve{Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(corners.size())), closed};
  for (std::size_t i = 0; i < corners.size(); ++i)
    curve.points.col(static_cast<Eigen::Index>(i)) = corners[i];
  return curve;
}

Polyline square_of_side(double side) {
  return polygon({{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}}, true);
}

// From the angles between edges of equal length.
double least_radius(const Polyline& curve, double edge) {
  const Polyline even =
      resample(curve, static_cast<int>(std::lround(edge_lengths(curve).sum() / edge)));
  const Eigen::Matrix3Xd edges = edge_vectors(even);
  double least = std::numeric_limits<double>::infinity();
  for (int i = curve.closed ? 0 : 1; i < edges.cols(); ++i) {
    const Eigen::Vector3d a = edges.col((i + edges.cols() - 1) % edges.cols());
    const Eigen::Vector3d b = edges.col(i);
    least = std::min(least, a.norm() / std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return least;
}

}  // namespace

TEST_CASE("the corners of a square become quarters of a circle") {
  const Rounded result = rounded(square_of_side(10), 2);
  REQUIRE_FALSE(result.no_room);
  REQUIRE(result.bends.size() == 4);
  for (int i = 0; i < 4; ++i) {
    CHECK(result.bends[i].vertex == i);
    CHECK(result.bends[i].angle == Approx(pi / 2));
  }
  CHECK(result.curve.closed);
  CHECK(least_radius(result.curve, 0.2) == Approx(2).epsilon(0.05));
  CHECK(edge_lengths(result.curve).sum() == Approx(4 * 6 + 2 * pi * 2).epsilon(0.02));
  CHECK(result.largest_move == Approx(2 * (std::sqrt(2) - 1)).epsilon(0.06));
  // It begins on the bend at vertex 0.
  CHECK((result.curve.points.col(0)).norm() < 1);
  CHECK(corners(resample(result.curve, 60)).empty());
}

TEST_CASE("what is no sharper stays as it is") {
  Polyline ring{Eigen::Matrix3Xd(3, 100), true};
  for (int i = 0; i < 100; ++i)
    ring.points.col(i) << 2 * std::cos(2 * pi * i / 100), 2 * std::sin(2 * pi * i / 100), 0;
  const Rounded same = rounded(ring, 2);
  CHECK(same.bends.empty());
  CHECK(same.curve.points == ring.points);
  const Rounded tight = rounded(ring, 3);
  CHECK(tight.no_room);
}

TEST_CASE("an open curve keeps its ends, in space too") {
  const Polyline zigzag =
      polygon({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {10, 10, 10}, {20, 15, 10}}, false);
  const Rounded result = rounded(zigzag, 1.5);
  REQUIRE_FALSE(result.no_room);
  CHECK(result.bends.size() == 3);
  CHECK(result.curve.points.col(0) == zigzag.points.col(0));
  CHECK(result.curve.points.rightCols<1>() == zigzag.points.rightCols<1>());
  CHECK(least_radius(result.curve, 0.15) > 0.93 * 1.5);
}

TEST_CASE("corners near each other become one bend, where there is room for it") {
  const Polyline chamfered = polygon({{0, 0, 0}, {10, 0, 0}, {11, 1, 0}, {11, 11, 0}}, false);
  const Rounded result = rounded(chamfered, 4);
  REQUIRE_FALSE(result.no_room);
  REQUIRE(result.bends.size() == 1);
  CHECK(result.bends[0].angle == Approx(pi / 2));
  CHECK(least_radius(result.curve, 0.5) > 0.93 * 4);
  // A strip one wide cannot turn round at a radius of four.
  const Polyline hairpin = polygon({{0, 0, 0}, {20, 0, 0}, {20, 1, 0}, {0, 1, 0}}, false);
  const Rounded none = rounded(hairpin, 4);
  REQUIRE(none.no_room);
  CHECK(none.curve.points == hairpin.points);
}

TEST_CASE("a stretch that bends too sharply is rounded as a whole") {
  // Two straight legs joined by a quarter of a circle of radius 1, of 9 points.
  std::vector<Eigen::Vector3d> points{{-10, 1, 0}, {-5, 1, 0}};
  for (int i = 0; i <= 8; ++i) {
    const double angle = pi / 2 * i / 8;
    points.emplace_back(std::sin(angle), std::cos(angle), 0);
  }
  points.insert(points.end(), {{1, -5, 0}, {1, -10, 0}});
  const Rounded result = rounded(polygon(points, false), 3);
  REQUIRE_FALSE(result.no_room);
  CHECK(result.bends.size() == 1);
  CHECK(result.bends[0].angle == Approx(pi / 2).epsilon(0.2));
  CHECK(least_radius(result.curve, 0.2) > 0.93 * 3);
}
