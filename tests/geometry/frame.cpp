#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <tencer/geometry/frame.hpp>

#include "shapes.hpp"

using namespace tencer::geometry;

namespace {

// All distances between corners are equal.
bool regular(const Eigen::Matrix3Xd& corners) {
  const double side = (corners.col(0) - corners.col(1)).norm();
  for (int i = 0; i < corners.cols(); ++i)
    for (int j = 0; j < i; ++j)
      if (std::abs((corners.col(i) - corners.col(j)).norm() - side) > 1e-9 * side) return false;
  return true;
}

// Least distance of points within a triangle or tetrahedron to its faces.
double clearance(const Eigen::Matrix3Xd& corners, const Eigen::Matrix3Xd& points) {
  double least = 1e300;
  const Eigen::Vector3d centre = corners.rowwise().mean();
  for (int corner = 0; corner < corners.cols(); ++corner) {
    const Eigen::Vector3d normal = (centre - corners.col(corner)).normalized();
    const double face = normal.dot(corners.col((corner + 1) % corners.cols()));
    least = std::min(least, face - (normal.transpose() * points).maxCoeff());
  }
  return least;
}

// The same for a box with faces along the first axes.
double box_clearance(const Eigen::Matrix3Xd& corners, const Eigen::Matrix3Xd& points, int axes) {
  double least = 1e300;
  for (int axis = 0; axis < axes; ++axis)
    least = std::min({least, points.row(axis).minCoeff() - corners.row(axis).minCoeff(),
                      corners.row(axis).maxCoeff() - points.row(axis).maxCoeff()});
  return least;
}

}  // namespace

TEST_CASE("a cube about a helix") {
  const Polyline curve = test::helix(50, 33, 1.5, 100);
  const Eigen::Matrix3Xd corners = enclosing_frame(FrameShape::cube, curve.points, 5, false);
  REQUIRE(corners.cols() == 8);
  const Eigen::Vector3d size = corners.rowwise().maxCoeff() - corners.rowwise().minCoeff();
  const Eigen::Vector3d inner =
      curve.points.rowwise().maxCoeff() - curve.points.rowwise().minCoeff();
  for (int axis = 0; axis < 3; ++axis) CHECK(size[axis] == Approx(inner.maxCoeff() + 10));
  CHECK(box_clearance(corners, curve.points, 3) == Approx(5));
}

TEST_CASE("a tetrahedron touches what it encloses at the margin") {
  const Polyline curve = test::helix(50, 33, 1.5, 100);
  const Eigen::Matrix3Xd corners = enclosing_frame(FrameShape::tetrahedron, curve.points, 5, false);
  REQUIRE(corners.cols() == 4);
  CHECK(regular(corners));
  CHECK(clearance(corners, curve.points) == Approx(5));
}

TEST_CASE("frames about planar targets lie in their plane") {
  Polyline curve = test::ellipse(30, 20, 60);
  curve.points.row(2).setConstant(7);
  for (const FrameShape shape : {FrameShape::cube, FrameShape::tetrahedron}) {
    const Eigen::Matrix3Xd corners = enclosing_frame(shape, curve.points, 5, true);
    REQUIRE(corners.cols() == (shape == FrameShape::cube ? 4 : 3));
    CHECK((corners.row(2).array() == 7).all());
    if (shape == FrameShape::tetrahedron) {
      CHECK(regular(corners));
      CHECK(clearance(corners, curve.points) == Approx(5));
    } else {
      CHECK((corners.row(0).maxCoeff() - corners.row(0).minCoeff()) == Approx(70));
      CHECK(box_clearance(corners, curve.points, 2) == Approx(5));
    }
  }
}

TEST_CASE("a frame needs points and a margin") {
  const Eigen::Matrix3Xd point = Eigen::Vector3d::Zero();
  CHECK_THROWS_AS(enclosing_frame(FrameShape::cube, point, 0, false), std::invalid_argument);
  CHECK_THROWS_AS(enclosing_frame(FrameShape::cube, Eigen::Matrix3Xd(3, 0), 1, false),
                  std::invalid_argument);
}
