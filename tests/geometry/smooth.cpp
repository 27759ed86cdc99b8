#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/geometry/smooth.hpp>

using namespace tencer::geometry;
using std::numbers::pi;

namespace {

Polyline ring(int n) {
  Polyline curve{Eigen::Matrix3Xd(3, n), true};
  for (int i = 0; i < n; ++i)
    curve.points.col(i) << std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0;
  return curve;
}

}  // namespace

TEST_CASE("a smooth line keeps the vertices and follows the curve between them") {
  const Polyline curve = ring(24);
  const Polyline smooth = smoothed(curve, 4);
  REQUIRE(smooth.closed);
  REQUIRE(smooth.vertices() == 96);
  for (int i = 0; i < 24; ++i) CHECK(smooth.points.col(4 * i) == curve.points.col(i));
  // Chords would be off by 1 - cos(pi / 24), 0.0086.
  for (const auto& point : smooth.points.colwise()) CHECK(std::abs(point.norm() - 1) < 2e-4);
}

TEST_CASE("corners of a smooth line stay, also at the seam") {
  for (const bool closed : {true, false}) {
    Polyline square{Eigen::Matrix3Xd(3, 12), closed};
    for (int i = 0; i < 12; ++i) {
      const int side = i / 3;
      const double t = i % 3 / 3.0;
      const double x = side == 0 ? t : side == 1 ? 1 : side == 2 ? 1 - t : 0;
      const double y = side == 0 ? 0 : side == 1 ? t : side == 2 ? 1 : 1 - t;
      square.points.col(i) << x, y, 0;
    }
    const Polyline smooth = smoothed(square, 5);
    REQUIRE(smooth.vertices() == (closed ? 60 : 56));
    for (const auto& point : smooth.points.colwise()) {
      const Eigen::Array2d from_middle = (point.head<2>().array() - 0.5).abs();
      CHECK(from_middle.maxCoeff() == Approx(0.5).margin(1e-12));
    }
  }
}

TEST_CASE("an edge in no pieces is a mistake") {
  CHECK_THROWS_AS(smoothed(ring(8), 0), std::invalid_argument);
}
