#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <tencer/geometry/corners.hpp>
#include <tencer/geometry/sampling.hpp>

using namespace tencer::geometry;

namespace {

constexpr double right_angle = std::numbers::pi / 2;

Polyline square(int vertices) {
  Polyline corners{.points = Eigen::Matrix3Xd(3, 4), .closed = true};
  corners.points << 0, 10, 10, 0, 0, 0, 10, 10, 0, 0, 0, 0;
  return resample(corners, vertices);
}

// Once around a trefoil.
Polyline trefoil(int vertices) {
  const auto point = [](double t) -> Eigen::Vector3d {
    return {std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t)};
  };
  return sample(point, 0, 2 * std::numbers::pi, vertices, true);
}

Polyline shaken(Polyline curve, double by) {
  std::mt19937 random(7);
  std::normal_distribution<double> draw(0, by);
  for (double& x : curve.points.reshaped()) x += draw(random);
  return curve;
}

}  // namespace

TEST_CASE("the corners of a square, coarse or fine") {
  for (const int vertices : {4, 8, 40}) {
    CAPTURE(vertices);
    const auto found = corners(square(vertices));
    REQUIRE(found.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(found[i].angle == Approx(right_angle));
      CHECK(found[i].s == Approx(10.0 * static_cast<double>(i)).margin(1e-12));
    }
    CHECK_FALSE(is_rough(square(vertices)));
  }
}

TEST_CASE("the corner of an open curve, and a slight one among straight edges") {
  Polyline bent{.points = Eigen::Matrix3Xd::Zero(3, 9), .closed = false};
  for (int i = 1; i < 9; ++i)
    bent.points.col(i) =
        bent.points.col(i - 1) +
        (i <= 5 ? Eigen::Vector3d(1, 0, 0)
                : Eigen::Vector3d(std::cos(0.5), std::sin(0.5), 0));  // 29 degrees at vertex 5
  const auto found = corners(bent);
  REQUIRE(found.size() == 1);
  CHECK(found[0].vertex == 5);
  CHECK(found[0].s == Approx(5));
  CHECK(found[0].angle == Approx(0.5));
}

TEST_CASE("smooth curves have no corners and are not rough, down to few vertices") {
  for (const int vertices : {30, 60, 400}) {
    CAPTURE(vertices);
    CHECK(corners(trefoil(vertices)).empty());
    CHECK_FALSE(is_rough(trefoil(vertices)));
  }
  Polyline line{.points = Eigen::Matrix3Xd::Zero(3, 50), .closed = false};
  line.points.row(0).setLinSpaced(0, 1);
  CHECK(corners(line).empty());
  CHECK_FALSE(is_rough(shaken(line, 1e-9)));  // rounding
  CHECK(corners({.points = Eigen::Matrix3Xd::Identity(3, 2), .closed = false}).empty());
}

TEST_CASE("a curve with noise is rough") {
  CHECK(is_rough(shaken(trefoil(120), 0.08)));
  CHECK_FALSE(is_rough(shaken(trefoil(120), 0.0005)));
}

TEST_CASE("noise has a place where it is worst") {
  Polyline curve = shaken(trefoil(120), 0.01);
  curve.points.col(37) +=
      4 * (curve.points.col(38) - curve.points.col(37)).norm() * Eigen::Vector3d(0.05, 0.05, 0.1);
  const auto worst = roughest(curve);
  CHECK(std::abs(worst.vertex - 37) <= 2);
  CHECK(worst.s == Approx(edge_lengths(curve).head(worst.vertex).sum()));
}
