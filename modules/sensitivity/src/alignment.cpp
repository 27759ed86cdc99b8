#include "alignment.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <tencer/registration/seen.hpp>
#include <utility>
#include <vector>

namespace tencer::sensitivity {
namespace {

// Inverse on the range; directions that do not count (turning a straight rod about itself) get 0.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& symmetric) {
  constexpr double tolerance = 1e-9;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
  Eigen::VectorXd inverse = eigen.eigenvalues();
  const double largest = inverse.cwiseAbs().maxCoeff();
  for (double& value : inverse) value = std::abs(value) > tolerance * largest ? 1 / value : 0;
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

// sum w ((a . b) I - (a b^T + b a^T) / 2), half of T's second derivative when the aligned target,
// b from its centre, turns against the shape, a from the same centre. For a = b it is the inertia
// tensor.
Eigen::Matrix3d turning_stiffness(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b,
                                  const Eigen::VectorXd& w) {
  const Eigen::Matrix3d product = a * w.asDiagonal() * b.transpose();
  return product.trace() * Eigen::Matrix3d::Identity() - (product + product.transpose()) / 2;
}

// Shifts along and turns about the axes, of points with these arms (3 x n) from the centre of the
// turns: 3 n x 6.
Eigen::MatrixXd rigid_motions(const Eigen::Matrix3Xd& arms) {
  Eigen::MatrixXd motions(3 * arms.cols(), 6);
  for (Eigen::Index i = 0; i < arms.cols(); ++i) {
    const Eigen::Vector3d arm = arms.col(i);
    motions.block<3, 3>(3 * i, 0).setIdentity();
    motions.block<3, 3>(3 * i, 3) << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(),
        0;
  }
  return motions;
}

Eigen::MatrixXd weighted(const Eigen::MatrixXd& motions, const Eigen::VectorXd& weights) {
  return weights.transpose().replicate<3, 1>().reshaped().asDiagonal() * motions;
}

}  // namespace

// Motions of y.
Alignment alignment_in_space(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& y,
                             const Eigen::VectorXd& weights, Motions kind) {
  const Eigen::Vector3d centre = y * weights / weights.sum();
  const Eigen::Matrix3Xd b = y.colwise() - centre;
  std::vector<int> shifts, turns;
  if (kind != Motions::none) {
    shifts = kind == Motions::in_plane ? std::vector<int>{0, 1} : std::vector<int>{0, 1, 2};
    turns = kind == Motions::in_plane ? std::vector<int>{5} : std::vector<int>{3, 4, 5};
  }
  std::vector<int> allowed = shifts;
  allowed.insert(allowed.end(), turns.begin(), turns.end());
  const Eigen::MatrixXd motions = rigid_motions(b)(Eigen::all, allowed);
  const auto compliance = [&](const Eigen::Matrix3Xd& a) -> Eigen::MatrixXd {
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(6, 6);
    for (int i : shifts) inverse(i, i) = 1 / weights.sum();
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(6, 6);
    stiffness.bottomRightCorner<3, 3>() = turning_stiffness(a, b, weights);
    if (!turns.empty()) inverse(turns, turns) = pseudo_inverse(stiffness(turns, turns));
    return inverse(allowed, allowed);
  };
  const Eigen::MatrixXd forces = weighted(motions, weights);
  return {.exact = {motions, forces, compliance(x.colwise() - centre)},
          .gauss_newton = {motions, forces, compliance(b)}};
}

// Motions of x against the target, whose views stay.
Alignment alignment_seen(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& y,
                         const Eigen::VectorXd& weights, const Eigen::Matrix3d& metric) {
  const double weight = weights.sum();
  const Eigen::Matrix3Xd away = x - y;
  const Eigen::Vector3d centre = x * weights / weight;
  const Eigen::Matrix3Xd b = x.colwise() - centre;
  const Eigen::MatrixXd motions = rigid_motions(b);
  Eigen::MatrixXd forces = weighted(motions, weights);
  for (Eigen::Index i = 0; i < b.cols(); ++i)
    forces.middleRows<3>(3 * i) = metric * forces.middleRows<3>(3 * i).eval();
  const auto compliance = [&](const Eigen::Matrix3Xd& from) {
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(6, 6);
    inverse.topLeftCorner<3, 3>() = pseudo_inverse(weight * metric);
    inverse.bottomRightCorner<3, 3>() =
        pseudo_inverse(registration::turning_stiffness(b, from, weights, metric));
    return inverse;
  };
  Alignment result{
      .gauss_newton = {motions, forces, compliance(Eigen::Matrix3Xd::Zero(3, b.cols()))}};
  // The pull on a vertex that turns with the shape turns too.
  for (Eigen::Index i = 0; i < b.cols(); ++i) {
    const Eigen::Vector3d pull = weights[i] * (metric * away.col(i));
    for (int axis = 0; axis < 3; ++axis)
      forces.block<3, 1>(3 * i, 3 + axis) += pull.cross(Eigen::Vector3d::Unit(axis));
  }
  result.exact = {motions, std::move(forces), compliance(away)};
  return result;
}

}  // namespace tencer::sensitivity
