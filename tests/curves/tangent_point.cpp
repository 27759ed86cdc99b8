#include "tangent_point.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "thickness.hpp"
#include "unknot.hpp"

using namespace tencer;
using namespace tencer::curves;
using geometry::Polyline;
using std::numbers::pi;

TEST_CASE("gradient of the tangent-point energy") {
  const Polyline curve = test::unknot(24);
  const TangentPoint at = tangent_point_energy(curve);
  const double h = 1e-6;
  for (int i = 0; i < 24; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      Polyline plus = curve, minus = curve;
      plus.points(axis, i) += h;
      minus.points(axis, i) -= h;
      const double difference =
          (tangent_point_energy(plus).energy - tangent_point_energy(minus).energy) / (2 * h);
      CHECK(at.gradient(axis, i) == Approx(difference).epsilon(1e-6).margin(1e-5));
    }
}

TEST_CASE("tangent-point energy and thickness of a circle") {
  // Every circle tangent to it that meets it again is the circle itself, |T x d| / |d|^2 = 1 /
  // (2R): the energy is L (2 pi R)^2 / (2R)^3.
  Polyline circle{Eigen::Matrix3Xd(3, 1000), true};
  for (int i = 0; i < 1000; ++i)
    circle.points.col(i) << 5 * std::cos(2 * pi * i / 1000), 5 * std::sin(2 * pi * i / 1000), 1;
  CHECK(tangent_point_energy(circle).energy == Approx(pi * pi * pi).epsilon(2e-3));
  CHECK(test::thickness(circle) == Approx(5).epsilon(1e-4));
}
