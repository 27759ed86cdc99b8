#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
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

// The spline as the textbooks have it: second derivatives from a full matrix, row by row.
Curve spline_by_dense_algebra(const Polyline& points) {
  const int n = points.vertices();
  const Eigen::VectorXd h = edge_lengths(points);
  Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, 3);
  const Eigen::Matrix3Xd edges = edge_vectors(points);
  for (int i = 0; i < n; ++i) {
    if (!points.closed && (i == 0 || i == n - 1)) continue;
    const int before = (i + n - 1) % n, after = (i + 1) % n;
    system(i, i) = (h[before] + h[i]) / 3;
    system(i, before) += h[before] / 6;
    system(i, after) += h[i] / 6;
    right.row(i) = edges.col(i).transpose() / h[i] - edges.col(before).transpose() / h[before];
  }
  const Eigen::Matrix3Xd bends = system.fullPivLu().solve(right).transpose();
  return [=](double at) -> Vector3d {
    const auto [i, t] = arc_length(points).locate(at);
    const int next = (i + 1) % n;
    return (1 - t) * points.points.col(i) + t * points.points.col(next) +
           h[i] * h[i] / 6 *
               ((std::pow(1 - t, 3) - (1 - t)) * bends.col(i) +
                (std::pow(t, 3) - t) * bends.col(next));
  };
}

}  // namespace

TEST_CASE("a spline is the one dense algebra gives") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const bool closed : {true, false})
    for (const int n : {2, 3, 4, 5, 17, 200}) {
      if (closed && n < 3) continue;
      CAPTURE(closed, n);
      // Chords from a hundredth to two.
      Polyline points{Eigen::Matrix3Xd(3, n), closed};
      for (int i = 0; i < n; ++i) {
        const Vector3d step = Vector3d::NullaryExpr([&] { return number(random); });
        const double shrink = std::pow(10.0, number(random) - 1);
        points.points.col(i) = (i == 0 ? Vector3d(0, 0, 0) : Vector3d(points.points.col(i - 1))) +
                               shrink * step.normalized();
      }
      const Curve curve = spline(points);
      const Curve expected = spline_by_dense_algebra(points);
      const double length = edge_lengths(points).sum();
      double worst = 0;
      for (int k = 0; k <= 1000; ++k)
        worst = std::max(worst, (curve(length * k / 1000) - expected(length * k / 1000)).norm());
      CHECK(worst < 1e-12 * length);
    }
}

TEST_CASE("a spline through very many points") {
  // A dense matrix of these would not fit in memory.
  const int n = 200'000;
  const double angle = 2 * std::numbers::pi / n;
  for (const bool closed : {true, false}) {
    CAPTURE(closed);
    Polyline points{Eigen::Matrix3Xd(3, n), closed};
    for (int i = 0; i < n; ++i)
      points.points.col(i) << std::cos(i * angle), std::sin(i * angle), closed ? 0.0 : i * angle;
    const Curve curve = spline(points);
    const double length = edge_lengths(points).sum();
    for (const double part : {0.1, 1 / 3.0, 0.77}) {
      const Vector3d at = curve(part * length);
      CHECK(at.head<2>().norm() == Approx(1).epsilon(1e-12));
      if (!closed)
        CHECK(std::remainder(at.z() - std::atan2(at.y(), at.x()), 2 * std::numbers::pi) ==
              Approx(0).margin(1e-9));
    }
    CHECK((curve(0) - points.points.col(0)).norm() < 1e-12);
  }
}

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
