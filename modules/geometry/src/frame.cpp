#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/geometry/frame.hpp>

namespace tencer::geometry {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

Matrix3Xd cube(const Matrix3Xd& points, double margin, int dimensions) {
  const Vector3d low = points.rowwise().minCoeff();
  const Vector3d high = points.rowwise().maxCoeff();
  const Vector3d centre = (low + high) / 2;
  const double half = (high - low).head(dimensions).maxCoeff() / 2 + margin;
  Matrix3Xd corners(3, 1 << dimensions);
  for (int i = 0; i < corners.cols(); ++i) {
    corners.col(i) = centre;
    for (int axis = 0; axis < dimensions; ++axis)
      corners(axis, i) += (i >> axis) & 1 ? half : -half;
  }
  return corners;
}

// Outward unit normals of the faces; they add up to zero.
Matrix3Xd simplex_normals(int dimensions) {
  Matrix3Xd normals(3, dimensions + 1);
  if (dimensions == 2)
    normals << 0, std::sqrt(0.75), -std::sqrt(0.75), -1, 0.5, 0.5, 0, 0, 0;
  else
    normals << 0, std::sqrt(2.0 / 3), -std::sqrt(2.0 / 3), 0,  //
        std::sqrt(8.0) / 3, -std::sqrt(2.0) / 3, -std::sqrt(2.0) / 3, 0, 1.0 / 3, 1.0 / 3, 1.0 / 3,
        -1;
  return normals;
}

Matrix3Xd simplex(const Matrix3Xd& points, double margin, int dimensions) {
  const Matrix3Xd normals = simplex_normals(dimensions);
  // Faces normal . x = height, the inscribed circle or sphere about a centre with
  // normal . centre + radius = height; sum of normal normal^T = (d + 1) / d on the space of d axes.
  const Eigen::VectorXd heights =
      (normals.transpose() * points).rowwise().maxCoeff().array() + margin;
  const double radius = heights.mean();
  const double share = static_cast<double>(dimensions) / (dimensions + 1);
  Vector3d centre = share * (normals * heights);
  if (dimensions == 2) centre.z() = points(2, 0);
  return (-dimensions * radius * normals).colwise() + centre;
}

}  // namespace

Matrix3Xd enclosing_frame(FrameShape shape, const Matrix3Xd& points, double margin, bool planar) {
  core::require(points.cols() > 0 && margin > 0,
                "enclosing_frame: needs points and a positive margin");
  const int dimensions = planar ? 2 : 3;
  return shape == FrameShape::cube ? cube(points, margin, dimensions)
                                   : simplex(points, margin, dimensions);
}

}  // namespace tencer::geometry
