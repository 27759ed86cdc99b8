#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/geometry/spline.hpp>

#include "shapes.hpp"

using namespace tencer::geometry;
using Eigen::Vector3d;

namespace {

Polyline through(bool closed) {
  return {(Eigen::Matrix3Xd(3, 5) << 0, 2, 3, 1, -1, 0, 1, 3, 4, 2, 1, 0, 1, -1, 0).finished(),
          closed};
}

// One-sided differences of second order.
Vector3d slope(const Curve& curve, double at, double h) {
  return (-3 * curve(at) + 4 * curve(at + h) - curve(at + 2 * h)) / (2 * h);
}
Vector3d bend(const Curve& curve, double at, double h) {
  return (2 * curve(at) - 5 * curve(at + h) + 4 * curve(at + 2 * h) - curve(at + 3 * h)) / (h * h);
}

}  // namespace

TEST_CASE("a spline goes through its points with one slope and one curvature") {
  for (const bool closed : {true, false}) {
    CAPTURE(closed);
    const Polyline points = through(closed);
    const Curve curve = spline(points);
    const ArcLength arc = arc_length(points);
    const double h = 1e-3;
    for (int i = 0; i < 5; ++i) {
      const double at = arc.knots()[i];
      CHECK((curve(at) - points.points.col(i)).norm() < 1e-12);
      if (!closed && (i == 0 || i == 4)) {
        CHECK(bend(curve, at, i == 0 ? h : -h).norm() < 1e-6);
        continue;
      }
      const double before = at == 0 ? arc.length() : at;
      // Cubics: the differences of the slope are wrong by h^2 times the third derivative only.
      CHECK((slope(curve, at, h) - slope(curve, before, -h)).norm() < 1e-4);
      CHECK((bend(curve, at, h) - bend(curve, before, -h)).norm() < 1e-6);
    }
  }
}

TEST_CASE("a spline through points of a circle is nearly the circle") {
  const Polyline fine = sample_spline(test::ellipse(3, 3, 24), 240);
  REQUIRE(fine.vertices() == 240);
  REQUIRE(fine.closed);
  for (const auto& point : fine.points.colwise()) CHECK(point.norm() == Approx(3).epsilon(1e-4));
  CHECK(edge_lengths(fine).maxCoeff() / edge_lengths(fine).minCoeff() < 1.0001);
}

TEST_CASE("a spline through two points is straight") {
  const Polyline line{(Eigen::Matrix3Xd(3, 2) << 0, 4, 0, 2, 0, 0).finished(), false};
  const Polyline fine = sample_spline(line, 5);
  CHECK((fine.points.col(2) - Vector3d(2, 1, 0)).norm() < 1e-9);
  CHECK((fine.points.col(4) - Vector3d(4, 2, 0)).norm() < 1e-12);
}
