// How the alignment of a target with a shape follows the shape's displacements: T = sum w |x - y|^2
// is least in the rigid motions of the target, y the aligned one.
#pragma once

#include <Eigen/Core>

namespace tencer::sensitivity {

// What the alignment takes up of a displacement v of all vertices: motions * compliance * forces^T
// v.
struct TakenUp {
  Eigen::MatrixXd motions{};     // 3 n x k
  Eigen::MatrixXd forces{};      // 3 n x k: half of how T's slope in the motions varies with v
  Eigen::MatrixXd compliance{};  // k x k, inverse of half of T's second derivative in the motions
};

struct Alignment {
  TakenUp exact{};
  TakenUp gauss_newton{};  // as it would be if T's terms varied linearly
};

enum class Motions { none, in_plane, in_space };

// x, y: 3 x n; weights: n.
Alignment alignment_in_space(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& y,
                             const Eigen::VectorXd& weights, Motions allowed);

// The same in space for distances d that count as d^T metric d, in a frame that follows the target:
// not zero, positive semidefinite.
Alignment alignment_seen(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& y,
                         const Eigen::VectorXd& weights, const Eigen::Matrix3d& metric);

}  // namespace tencer::sensitivity
