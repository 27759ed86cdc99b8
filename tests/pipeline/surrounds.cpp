#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <tencer/pipeline/surrounds.hpp>

#include "fixtures/cube.hpp"

using namespace tencer;
using namespace tencer::pipeline;

namespace {

Eigen::Vector3d random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Vector3d::NullaryExpr([&] { return normal(random); }).normalized();
}

// Points on the surface of the cube from -1 to 1, its corners first.
Eigen::Matrix3Xd on_cube(int count, std::mt19937& random) {
  std::uniform_real_distribution<double> inside(-1, 1);
  Eigen::Matrix3Xd points(3, count);
  points.leftCols<8>() = cube(1);
  for (int i = 8; i < count; ++i) {
    points.col(i) = Eigen::Vector3d::NullaryExpr([&] { return inside(random); });
    points(i % 3, i) = i % 2 == 0 ? 1 : -1;
  }
  return points;
}

// Of a point from the cube from -1 to 1, or from the square in the first two axes.
double distance_from_cube(const Eigen::Vector3d& point, int axes) {
  return (point.head(axes).cwiseAbs().array() - 1).cwiseMax(0).matrix().norm();
}

}  // namespace

TEST_CASE("a cube holds what is within it and says how far out the rest is") {
  Eigen::Matrix3Xd points(3, 3);
  points << 0, 0.99, 1, 0, 0.99, -1, 0, -0.99, 1;
  CHECK(furthest_outside(cube(1), points, false).point == -1);
  points.col(1) << 0.2, 1.5, 0.1;
  const Outside out = furthest_outside(cube(1), points, false);
  CHECK(out.point == 1);
  CHECK(out.distance == Approx(0.5));
}

TEST_CASE("a hull without volume holds nothing") {
  const Eigen::Matrix3Xd origin = Eigen::Matrix3Xd::Zero(3, 1);
  Eigen::Matrix3Xd flat = cube(1);
  flat.row(2).setZero();
  CHECK(std::isinf(furthest_outside(flat, origin, false).distance));
  CHECK(std::isinf(furthest_outside(cube(1).leftCols(2), origin, false).distance));
  CHECK(std::isinf(furthest_outside(cube(1).leftCols(2), origin, true).distance));
  CHECK(std::isinf(furthest_outside(Eigen::Matrix3Xd(3, 0), origin, false).distance));
}

TEST_CASE("in the plane the hull is a polygon") {
  Eigen::Matrix3Xd triangle(3, 3);
  triangle << 0, 4, 0, 0, 0, 4, 0, 0, 0;
  Eigen::Matrix3Xd points(3, 2);
  points << 1, 3, 1, 3, 0, 0;
  CHECK(furthest_outside(triangle, points.leftCols(1), true).point == -1);
  const Outside out = furthest_outside(triangle, points, true);
  CHECK(out.point == 1);
  CHECK(out.distance == Approx(std::sqrt(2.0)));
}

TEST_CASE("a thousand anchors on a cube tell what is within and how far out the rest is") {
  std::mt19937 random(3);
  const Eigen::Matrix3Xd anchors = on_cube(1000, random);
  std::uniform_real_distribution<double> anywhere(-1.5, 1.5);
  int outside = 0;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d point = Eigen::Vector3d::NullaryExpr([&] { return anywhere(random); });
    const double distance = distance_from_cube(point, 3);
    const Outside found = furthest_outside(anchors, point, false);
    REQUIRE(found.point == (distance > 0 ? 0 : -1));
    REQUIRE(found.distance == Approx(distance).margin(1e-6));
    outside += distance > 0;
  }
  CHECK(outside > 100);
  CHECK(outside < 290);
  // On a face, an edge and a corner.
  Eigen::Matrix3Xd on(3, 3);
  on << 1, 1, 1, 0.2, 1, 1, -0.3, 0.4, -1;
  CHECK(furthest_outside(anchors, on, false).point == -1);
  CHECK(furthest_outside(anchors, 1.0001 * on, false).point == 2);
}

TEST_CASE("a thousand anchors on a sphere surround a thousand points and miss one") {
  std::mt19937 random(8);
  Eigen::Matrix3Xd anchors(3, 1000), points(3, 1000);
  for (auto anchor : anchors.colwise()) anchor = 40 * random_direction(random);
  for (auto point : points.colwise()) point = 36 * random_direction(random);
  CHECK(furthest_outside(anchors, points, false).point == -1);
  points.col(617) *= 60 / 36.0;
  const Outside found = furthest_outside(anchors, points, false);
  CHECK(found.point == 617);
  // The hull lies within the sphere, and hardly.
  CHECK(found.distance > 20);
  CHECK(found.distance < 21);
}

TEST_CASE("a thousand anchors in the plane") {
  std::mt19937 random(4);
  Eigen::Matrix3Xd anchors = on_cube(1000, random);
  anchors.row(2).setConstant(7);
  std::uniform_real_distribution<double> anywhere(-1.5, 1.5);
  for (int i = 0; i < 100; ++i) {
    Eigen::Vector3d point = Eigen::Vector3d::NullaryExpr([&] { return anywhere(random); });
    const double distance = distance_from_cube(point, 2);
    const Outside found = furthest_outside(anchors, point, true);
    REQUIRE(found.point == (distance > 0 ? 0 : -1));
    REQUIRE(found.distance == Approx(distance).margin(1e-6));
  }
}

TEST_CASE("a thousand anchors in a slanting plane or on a line surround nothing") {
  std::mt19937 random(4);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, random_direction(random)).toRotationMatrix();
  Eigen::Matrix3Xd flat = on_cube(1000, random);
  flat.row(2).setZero();
  const Eigen::Matrix3Xd slanting = (turn * flat).colwise() + Eigen::Vector3d(1, 2, 3);
  CHECK(std::isinf(furthest_outside(slanting, slanting.leftCols(1), false).distance));
  flat.row(1).setZero();
  const Eigen::Matrix3Xd line = (turn * flat).colwise() + Eigen::Vector3d(1, 2, 3);
  for (const bool planar : {false, true})
    CHECK(std::isinf(furthest_outside(line, line.leftCols(1), planar).distance));
}

TEST_CASE("anchors that repeat each other surround what one of each does") {
  const Eigen::Matrix3Xd anchors = cube(1).replicate<1, 50>();
  Eigen::Matrix3Xd points(3, 2);
  points << 0, 0.5, 0.99, -3, -0.99, 0;
  CHECK(furthest_outside(anchors, points.leftCols(1), false).point == -1);
  const Outside found = furthest_outside(anchors, points, false);
  CHECK(found.point == 1);
  CHECK(found.distance == Approx(2));
}

TEST_CASE("what is within does not depend on the unit or the place") {
  std::mt19937 random(6);
  const Eigen::Matrix3Xd anchors = on_cube(50, random);
  Eigen::Matrix3Xd points(3, 2);
  points << 0.2, 0.5, -0.9, 1.25, 0.9, 0;
  for (const double unit : {1e-6, 1e6}) {
    const Eigen::Vector3d place = unit * Eigen::Vector3d(10, -20, 30);
    const Eigen::Matrix3Xd moved = (unit * points).colwise() + place;
    const Outside found = furthest_outside((unit * anchors).colwise() + place, moved, false);
    CHECK(found.point == 1);
    CHECK(found.distance == Approx(0.25 * unit).epsilon(1e-5));
    CHECK(furthest_outside((unit * anchors).colwise() + place, moved.leftCols(1), false).point ==
          -1);
  }
}
