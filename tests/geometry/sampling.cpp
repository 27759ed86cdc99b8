#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/geometry/sampling.hpp>

using namespace tencer::geometry;
using std::numbers::pi;

namespace {

Polyline unit_square(bool closed) {
  Polyline square{Eigen::Matrix3Xd(3, 4), closed};
  square.points << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  return square;
}

}  // namespace

TEST_CASE("a point at an arc length lies on its edge") {
  const Polyline square = unit_square(true);
  const ArcLength arc = arc_length(square);
  CHECK(arc.length() == 4.0);
  CHECK(point_at(square, arc, 0.25) == Eigen::Vector3d(0.25, 0, 0));
  CHECK(point_at(square, arc, 3.75) == Eigen::Vector3d(0, 0.25, 0));
  CHECK(point_at(square, arc, -0.25) == Eigen::Vector3d(0, 0.25, 0));
  CHECK(point_at(square, arc, 4.0) == Eigen::Vector3d(0, 0, 0));
  const Polyline open = unit_square(false);
  CHECK(point_at(open, arc_length(open), 9.0) == Eigen::Vector3d(0, 1, 0));
  CHECK_THROWS_AS(point_at(open, arc, 0.0), std::invalid_argument);
}

TEST_CASE("resampling puts points at equal arc length") {
  const Polyline closed = resample(unit_square(true), 8);
  REQUIRE(closed.closed);
  REQUIRE(closed.vertices() == 8);
  CHECK(edge_lengths(closed).isApproxToConstant(0.5, 1e-15));
  CHECK(closed.points.col(5) == Eigen::Vector3d(0.5, 1, 0));

  const Polyline open = resample(unit_square(false), 7);
  REQUIRE_FALSE(open.closed);
  CHECK(edge_lengths(open).isApproxToConstant(0.5, 1e-15));
  CHECK(open.points.col(0) == Eigen::Vector3d(0, 0, 0));
  CHECK(open.points.col(6) == Eigen::Vector3d(0, 1, 0));

  CHECK_THROWS_AS(resample(unit_square(true), 2), std::invalid_argument);
  CHECK_THROWS_AS(resample(unit_square(false), 1), std::invalid_argument);
}

TEST_CASE("resampling at the vertices of an equal-edged polyline changes nothing") {
  Polyline ring{Eigen::Matrix3Xd(3, 37), true};
  for (int i = 0; i < 37; ++i)
    ring.points.col(i) << std::cos(2 * pi * i / 37), std::sin(2 * pi * i / 37), 0.1;
  CHECK((resample(ring, 37).points - ring.points).cwiseAbs().maxCoeff() < 1e-14);
}

TEST_CASE("sampling a smooth curve gives equal arc lengths whatever its parameter's speed") {
  // A quarter circle run through with a speed that varies by a factor of 20.
  const auto angle = [](double t) { return pi / 2 * (t + 20 * t * t) / 21; };
  const Curve quarter = [&](double t) {
    return Eigen::Vector3d(std::cos(angle(t)), std::sin(angle(t)), 0);
  };
  CHECK(length(quarter, 0, 1) == Approx(pi / 2).epsilon(1e-12));
  const Polyline sampled = sample(quarter, 0, 1, 10, false);
  for (int i = 0; i < 10; ++i) {
    const double exact = pi / 2 * i / 9;
    CHECK((sampled.points.col(i) - Eigen::Vector3d(std::cos(exact), std::sin(exact), 0)).norm() <
          1e-8);
  }
  CHECK((sampled.points.colwise().norm().array() - 1.0).abs().maxCoeff() < 1e-15);
}

TEST_CASE(
    "points between vertices follow a smooth curve to fourth order, to the ends of open ones") {
  const auto circle = [](double s) { return Eigen::Vector3d(std::cos(s), std::sin(s), 0.3 * s); };
  for (const bool closed : {true, false}) {
    double last = 0;
    for (const int n : {24, 48}) {
      const int edges = closed ? n : n - 1;
      Eigen::Matrix3Xd points(3, n);
      for (int i = 0; i < n; ++i) {
        points.col(i) = circle(2 * pi * i / edges);
        if (closed) points(2, i) = 0;
      }
      const ArcLength arc(Eigen::VectorXd::Constant(edges, 2 * pi / edges), closed);
      const Eigen::VectorXd at = Eigen::VectorXd::LinSpaced(200, 0.0, 2 * pi * 0.999);
      const Eigen::Matrix3Xd found = smooth_points(points, arc, at);
      double error = 0;
      for (int k = 0; k < 200; ++k) {
        Eigen::Vector3d exact = circle(at[k]);
        if (closed) exact.z() = 0;
        // The ends of an open curve have one-sided slopes, of lower order.
        const bool inside = closed || (at[k] > 1 && at[k] < 2 * pi - 1);
        if (inside) error = std::max(error, (found.col(k) - exact).norm());
      }
      if (n == 48) CHECK(error < last / 7.0);
      last = error;
    }
    CHECK(last < 1e-4);
  }
}
