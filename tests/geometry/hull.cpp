#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/geometry/hull.hpp>

#include "fixtures/cube.hpp"

using namespace tencer;
using namespace tencer::geometry;

TEST_CASE("a cube holds what is within it and says how far out the rest is") {
  Eigen::Matrix3Xd points(3, 3);
  points << 0, 0.99, 1, 0, 0.99, -1, 0, -0.99, 1;
  CHECK(outside_hull(cube(1), points, false).point == -1);
  points.col(1) << 0.2, 1.5, 0.1;
  const Outside out = outside_hull(cube(1), points, false);
  CHECK(out.point == 1);
  CHECK(out.distance == Approx(0.5));
}

TEST_CASE("a hull without volume holds nothing") {
  const Eigen::Matrix3Xd origin = Eigen::Matrix3Xd::Zero(3, 1);
  Eigen::Matrix3Xd flat = cube(1);
  flat.row(2).setZero();
  CHECK(std::isinf(outside_hull(flat, origin, false).distance));
  CHECK(std::isinf(outside_hull(cube(1).leftCols(2), origin, false).distance));
  CHECK(std::isinf(outside_hull(cube(1).leftCols(2), origin, true).distance));
  CHECK(std::isinf(outside_hull(Eigen::Matrix3Xd(3, 0), origin, false).distance));
}

TEST_CASE("in the plane the hull is a polygon") {
  Eigen::Matrix3Xd triangle(3, 3);
  triangle << 0, 4, 0, 0, 0, 4, 0, 0, 0;
  Eigen::Matrix3Xd points(3, 2);
  points << 1, 3, 1, 3, 0, 0;
  CHECK(outside_hull(triangle, points.leftCols(1), true).point == -1);
  const Outside out = outside_hull(triangle, points, true);
  CHECK(out.point == 1);
  CHECK(out.distance == Approx(std::sqrt(2.0)));
}
