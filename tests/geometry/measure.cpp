#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <tencer/geometry/measure.hpp>

using namespace tencer::geometry;

namespace {

Polyline random_curve(std::mt19937& random, int n, bool closed) {
  std::normal_distribution<double> normal;
  Polyline curve{Eigen::Matrix3Xd(3, n), closed};
  for (double& x : curve.points.reshaped()) x = normal(random);
  return curve;
}

// The distance of two segments by search: for each point of a fine grid on a, the closest point of
// b by projection.
double searched_distance(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1,
                         const Eigen::Vector3d& b0, const Eigen::Vector3d& b1) {
  double best = 1e300;
  for (int i = 0; i <= 2000; ++i) {
    const Eigen::Vector3d x = a0 + (a1 - a0) * i / 2000.0;
    const double t = std::clamp((x - b0).dot(b1 - b0) / (b1 - b0).squaredNorm(), 0.0, 1.0);
    best = std::min(best, (x - b0 - t * (b1 - b0)).norm());
  }
  return best;
}

}  // namespace

TEST_CASE("bounding box diagonal is that of all curves together") {
  std::vector<Polyline> curves(2);
  curves[0].points = Eigen::Vector3d(1, 2, 3);
  curves[1].points = Eigen::Vector3d(4, 6, 15);
  CHECK(bounding_box_diagonal(curves) == 13.0);
  CHECK(bounding_box_diagonal({}) == 0.0);
}

TEST_CASE("segment distance agrees with a search") {
  std::mt19937 random(5);
  for (int trial = 0; trial < 300; ++trial) {
    Polyline four = random_curve(random, 4, false);
    // Also coplanar and parallel pairs.
    if (trial % 3 == 1) four.points.row(2).setZero();
    if (trial % 3 == 2)
      four.points.col(3) = four.points.col(2) + 0.7 * (four.points.col(1) - four.points.col(0));
    const Eigen::Vector3d a0 = four.points.col(0), a1 = four.points.col(1);
    const Eigen::Vector3d b0 = four.points.col(2), b1 = four.points.col(3);
    const SegmentApproach found = segment_approach(a0, a1, b0, b1);
    const double searched = searched_distance(a0, a1, b0, b1);
    REQUIRE(found.distance <= searched + 1e-12);
    REQUIRE(found.distance >= searched - (a1 - a0).norm() / 4000);
    REQUIRE((found.t_a >= 0 && found.t_a <= 1 && found.t_b >= 0 && found.t_b <= 1));
    const Eigen::Vector3d gap =
        (1 - found.t_a) * a0 + found.t_a * a1 - ((1 - found.t_b) * b0 + found.t_b * b1);
    REQUIRE(gap.norm() == Approx(found.distance).margin(1e-12));
  }
}

TEST_CASE("segment distance: crossing, overlapping, and single points") {
  const Eigen::Vector3d o(0, 0, 0), x(1, 0, 0), y(0, 1, 0);
  const SegmentApproach cross = segment_approach(-x, x, -y, 3 * y);
  CHECK(cross.distance == 0.0);
  CHECK(cross.t_a == 0.5);
  CHECK(cross.t_b == 0.25);
  CHECK(segment_approach(o, 2 * x, x, 3 * x).distance == 0.0);
  CHECK(segment_approach(o, o, y, y).distance == 1.0);
}

TEST_CASE("closest approach leaves out neighbours and agrees with trying all pairs") {
  std::mt19937 random(6);
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<Polyline> curves{random_curve(random, 9, trial % 2 == 0),
                                       random_curve(random, 5, trial % 3 == 0)};
    double best = 1e300;
    for (int rod_a = 0; rod_a < 2; ++rod_a)
      for (int rod_b = rod_a; rod_b < 2; ++rod_b)
        for (int i = 0; i < curves[rod_a].edges(); ++i)
          for (int j = 0; j < curves[rod_b].edges(); ++j) {
            const int na = curves[rod_a].vertices(), nb = curves[rod_b].vertices();
            const int i1 = (i + 1) % na, j1 = (j + 1) % nb;
            if (rod_a == rod_b && (i == j || i1 == j || j1 == i)) continue;
            best = std::min(
                best, segment_approach(curves[rod_a].points.col(i), curves[rod_a].points.col(i1),
                                       curves[rod_b].points.col(j), curves[rod_b].points.col(j1))
                          .distance);
          }
    const auto found = closest_approach(curves);
    REQUIRE(found);
    REQUIRE(found->distance == best);
  }
}

TEST_CASE("closest approach finds where a figure eight crosses itself") {
  Polyline eight{Eigen::Matrix3Xd(3, 4), true};
  eight.points << -1, 1, 1, -1, -1, 1, -1, 1, 0, 0, 0, 0;
  const auto found = closest_approach(std::vector{eight});
  REQUIRE(found);
  CHECK(found->distance < 1e-15);
  CHECK(found->a.edge == 0);
  CHECK(found->a.t == Approx(0.5));
  CHECK(found->b.edge == 2);
  CHECK(found->b.t == Approx(0.5));
  eight.points.conservativeResize(3, 3);
  CHECK_FALSE(closest_approach(std::vector{eight}));  // a triangle has neighbours only
}
