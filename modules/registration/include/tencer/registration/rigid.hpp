// Rigid registration of two point sets with known pairing (paper section 5.3; Sorkine-Hornung and
// Rabinovich 2017).
#pragma once

#include <Eigen/Core>

namespace tencer::registration {

// p -> rotation * p + translation, the translation in the unit of the points.
struct RigidMotion {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Matrix3Xd apply(const Eigen::Matrix3Xd& points) const {
    return (rotation * points).colwise() + translation;
  }
};

// The proper rigid motion that minimises sum_i w_i |motion(from_i) - to_i|^2. from, to: 3 x n;
// weights: n. Always a rotation, never a reflection. For collinear or coincident points, where it
// is not unique, the smallest rotation is returned. Throws std::invalid_argument unless n >= 1 is
// the same for all three and the weights are nonnegative and not all zero.
RigidMotion align(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                  const Eigen::VectorXd& weights);

}  // namespace tencer::registration
