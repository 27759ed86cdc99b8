#include "soft_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace tencer::sparsify {
namespace {

constexpr Eigen::Index followed = 3;

// Something that has a part of every mode, the same each time.
Eigen::MatrixXd any_motions(Eigen::Index size) {
  Eigen::MatrixXd motions(size, followed);
  for (Eigen::Index k = 0; k < followed; ++k)
    for (Eigen::Index i = 0; i < size; ++i)
      motions(i, k) =
          std::sin(1.0 + static_cast<double>(k) + 0.7 * static_cast<double>(i * (k + 1)));
  return motions;
}

}  // namespace

Eigen::VectorXd lumped_mass(const equilibrium::System& system) {
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(system.size());
  const auto& rods = system.structure().rods;
  for (int r = 0; r < static_cast<int>(rods.size()); ++r)
    for (int j = 0; j < rods[r].edges(); ++j)
      for (const int v : {j, (j + 1) % rods[r].vertices()})
        for (int axis = 0; axis < 3; ++axis)
          if (const int i = system.position_index(r, v, axis); i >= 0)
            mass[i] += rods[r].rest_lengths[j] / 2;
  return mass;
}

double eigenvalue_unit(const equilibrium::System& system) {
  double length = 0;
  double bending = 0;
  for (const auto& rod : system.structure().rods) {
    length += rod.length();
    bending = std::max({bending, rod.section.EI1, rod.section.EI2});
  }
  return bending / std::pow(length, 4);
}

SoftModes soft_modes(const sensitivity::Configuration& at, const SoftModes& nearby) {
  const bool known = nearby.modes.rows() == at.system.size();
  SoftModes result{.modes = known ? nearby.modes : any_motions(at.system.size())};
  const Eigen::VectorXd mass = lumped_mass(at.system);
  const double unit = eigenvalue_unit(at.system);
  for (int round = 0; round < (known ? 2 : 12); ++round) {
    Eigen::MatrixXd force = mass.asDiagonal() * result.modes;
    for (Eigen::Index k = 0; k < force.cols(); ++k)
      equilibrium::remove_rigid(at.linearisation.rigid, force.col(k));
    const Eigen::MatrixXd motion = at.linearisation.solve(force);
    // H motion = force, so this is the Rayleigh-Ritz problem of H and M on the motions.
    const Eigen::MatrixXd stiffness = motion.transpose() * force;
    const Eigen::MatrixXd inertia = motion.transpose() * mass.asDiagonal() * motion;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ritz(
        (stiffness + stiffness.transpose()) / 2, (inertia + inertia.transpose()) / 2);
    if (ritz.info() != Eigen::Success || !ritz.eigenvalues().allFinite())
      return {.modes = {}, .values = Eigen::VectorXd::Constant(followed, -1)};
    result.modes = motion * ritz.eigenvectors();
    result.values = ritz.eigenvalues() / unit;
  }
  return result;
}

Eigen::VectorXd soft_rates(const sensitivity::Configuration& at, const SoftModes& soft,
                           Eigen::Index k, std::span<const sensitivity::Parameter> parameters,
                           const Eigen::SparseMatrix<double>& ties, const Eigen::MatrixXd& motion) {
  const Eigen::VectorXd mode = soft.modes.col(k);
  const auto curvature = sensitivity::force_curvature(at.system, at.state, parameters, mode);
  const Eigen::VectorXd third =
      sensitivity::third_derivative_times(at.system, at.state, mode, mode);
  return (ties.transpose() * (curvature.mixed.transpose() * mode) + motion.transpose() * third) /
         eigenvalue_unit(at.system);
}

}  // namespace tencer::sparsify
