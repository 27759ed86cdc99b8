#include "drawing/axes.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace tencer::app {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d principal_axes(const Eigen::Matrix3Xd& points) {
  const Eigen::Matrix3Xd centred = points.colwise() - points.rowwise().mean();
  Matrix3d covariance = centred * centred.transpose();
  covariance += 0.02 * covariance.trace() * Vector3d(2, 1, 0).asDiagonal().toDenseMatrix();
  Matrix3d rows = Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance).eigenvectors().transpose();
  rows.row(0).swap(rows.row(2));  // the greatest extent first
  for (const int axis : {0, 1}) {
    Eigen::Index largest = 0;
    rows.row(axis).cwiseAbs().maxCoeff(&largest);
    if (rows(axis, largest) < 0) rows.row(axis) *= -1;
  }
  rows.row(2) = rows.row(0).cross(rows.row(1));
  return rows;
}

Matrix3d axes_along(const std::vector<model::View>& views) {
  const Vector3d towards = std::ranges::max(views, {}, &model::View::weight).direction.normalized();
  const Vector3d up = std::abs(towards.z()) > 0.99 ? Vector3d::UnitY() : Vector3d::UnitZ();
  Matrix3d rows;
  rows.row(0) = up.cross(towards).normalized();
  rows.row(2) = towards;
  rows.row(1) = towards.cross(rows.row(0).transpose());
  return rows;
}

Matrix3d from_above(const Matrix3d& axes) {
  Matrix3d above = axes;
  above.row(1) = -axes.row(2);
  above.row(2) = axes.row(1);
  return above;
}

Matrix3d from_right(const Matrix3d& axes) {
  Matrix3d right = axes;
  right.row(0) = -axes.row(2);
  right.row(2) = axes.row(0);
  return right;
}

Matrix3d oblique(const Matrix3d& axes) {
  const auto tilt =
      Eigen::AngleAxisd(-0.5, Vector3d::UnitX()) * Eigen::AngleAxisd(0.35, Vector3d::UnitY());
  return tilt.toRotationMatrix() * axes;
}

Matrix3d oblique_axes(const Eigen::Matrix3Xd& points) { return oblique(principal_axes(points)); }

}  // namespace tencer::app
