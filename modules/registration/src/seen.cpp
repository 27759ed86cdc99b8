#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/registration/seen.hpp>

namespace tencer::registration {
namespace {

// All that the sum depends on, for centred sets z, which turns, and y, which stays.
struct Moments {
  Eigen::Matrix3d zz = Eigen::Matrix3d::Zero();  // sum w z z^T
  Eigen::Matrix3d zy = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d yy = Eigen::Matrix3d::Zero();
};

Moments turned(const Moments& by, const Eigen::Matrix3d& turn) {
  return {.zz = turn * by.zz * turn.transpose(), .zy = turn * by.zy, .yy = by.yy};
}

double squares(const Moments& m, const Eigen::Matrix3d& metric) {
  return (metric * (m.zz - m.zy - m.zy.transpose() + m.yy)).trace();
}

// z -> turn x z for each of the three turns: d^T M d of it, and the bend of the circle against the
// forces w M (z - y), of which pull = sum w M (z - y) z^T.
Eigen::Matrix3d stiffness(const Eigen::Matrix3d& zz, const Eigen::Matrix3d& pull,
                          const Eigen::Matrix3d& metric) {
  std::array<Eigen::Matrix3d, 3> turns;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i);
    turns[i] << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  }
  Eigen::Matrix3d result =
      (pull + pull.transpose()) / 2 - pull.trace() * Eigen::Matrix3d::Identity();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      result(i, j) += (turns[i].transpose() * metric * turns[j] * zz).trace();
  return result;
}

// Newton's step, turned downhill where the sum bends the other way, and never wide.
Eigen::Vector3d step_of(const Eigen::Matrix3d& stiff, const Eigen::Vector3d& downhill) {
  constexpr double flat = 1e-10;  // of the stiffest turn
  constexpr double widest = 0.5;  // radians
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(stiff);
  const double largest = eigen.eigenvalues().cwiseAbs().maxCoeff();
  if (!(largest > 0)) return Eigen::Vector3d::Zero();
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const double bend = std::abs(eigen.eigenvalues()[i]);
    if (bend <= flat * largest) continue;
    const Eigen::Vector3d axis = eigen.eigenvectors().col(i);
    step += axis * (axis.dot(downhill) / bend);
  }
  return step * std::min(1.0, widest / std::max(step.norm(), 1e-300));
}

Eigen::Matrix3d rotation_by(const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  if (!(angle > 0)) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

// The turn of z that makes the sum least, near none.
Eigen::Matrix3d best_turn(const Moments& given, const Eigen::Matrix3d& metric) {
  constexpr int most = 100;
  constexpr double done = 1e-15;  // radians
  constexpr double small = 1e-6;  // radians, where rounding hides what a step gains
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Moments now = given;
  double value = squares(now, metric);
  double last = 2 * small;
  for (int i = 0; i < most; ++i) {
    const Eigen::Matrix3d pull = metric * (now.zz - now.zy.transpose());
    // sum z x force, which turns z back.
    const Eigen::Vector3d moment(pull(2, 1) - pull(1, 2), pull(0, 2) - pull(2, 0),
                                 pull(1, 0) - pull(0, 1));
    Eigen::Vector3d step = step_of(stiffness(now.zz, pull, metric), moment);
    // Near the end steps shrink fast, until what is left of them is rounding.
    if (last <= small && step.norm() > last / 2) break;
    bool moved = false;
    for (int halved = 0; halved < 30 && !moved && step.norm() > done; ++halved, step /= 2) {
      // A product of many turns would drift away from a rotation.
      const Eigen::Matrix3d next =
          Eigen::Quaterniond(rotation_by(-step) * turn).normalized().toRotationMatrix();
      const Moments there = turned(given, next);
      const double reached = squares(there, metric);
      if (reached >= value && step.norm() > small) continue;
      moved = true;
      last = step.norm();
      turn = next;
      now = there;
      value = std::min(value, reached);
    }
    if (!moved) break;
  }
  return turn;
}

}  // namespace

RigidMotion align_seen(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                       const Eigen::VectorXd& weights, const Eigen::Matrix3d& metric) {
  core::require(metric.allFinite(), "align_seen: needs a finite metric");
  const RigidMotion first = align(from, to, weights);
  const Eigen::Vector3d from_centre = from * weights / weights.sum();
  const Eigen::Vector3d to_centre = to * weights / weights.sum();
  const Eigen::Matrix3Xd y = from.colwise() - from_centre;
  const Eigen::Matrix3Xd z = first.rotation.transpose() * (to.colwise() - to_centre);
  const Eigen::Matrix3d turn = best_turn({.zz = z * weights.asDiagonal() * z.transpose(),
                                          .zy = z * weights.asDiagonal() * y.transpose(),
                                          .yy = y * weights.asDiagonal() * y.transpose()},
                                         metric);
  RigidMotion motion{.rotation = first.rotation * turn.transpose()};
  motion.translation = to_centre - motion.rotation * from_centre;
  return motion;
}

Eigen::Matrix3d turning_stiffness(const Eigen::Matrix3Xd& arms, const Eigen::Matrix3Xd& away,
                                  const Eigen::VectorXd& weights, const Eigen::Matrix3d& metric) {
  return stiffness(arms * weights.asDiagonal() * arms.transpose(),
                   metric * away * weights.asDiagonal() * arms.transpose(), metric);
}

}  // namespace tencer::registration
