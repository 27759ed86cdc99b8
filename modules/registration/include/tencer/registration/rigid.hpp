// Rigid registration of two point sets with known pairing (paper section 5.3; Sorkine-Hornung and
// Rabinovich 2017).
#pragma once

#include <Eigen/Core>
#include <array>

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

// The same among the motions that keep z: a turn about it and a shift across it. No turn where none
// is better than another.
RigidMotion align_in_plane(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                           const Eigen::VectorXd& weights);

// An orthogonal matrix Q, and what is left: sum_i |Q from_i - to_i|^2.
struct OrthogonalFit {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  double squares = 0.0;
};

// The best fits of two point sets (3 x n) about the origin: a rotation, then a reflection or rotary
// reflection.
std::array<OrthogonalFit, 2> orthogonal_fits(const Eigen::Matrix3Xd& from,
                                             const Eigen::Matrix3Xd& to);

}  // namespace tencer::registration
