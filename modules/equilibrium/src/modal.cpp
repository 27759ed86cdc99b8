#include <algorithm>
#include <cmath>
#include <tencer/equilibrium/modal.hpp>
#include <tencer/linalg/dense.hpp>
#include <utility>

namespace tencer::equilibrium {
namespace {

constexpr Eigen::Index mode_count = 3;

// Something that has a part of every mode, the same each time.
Eigen::MatrixXd any_motions(Eigen::Index size) {
  Eigen::MatrixXd motions(size, mode_count);
  for (Eigen::Index k = 0; k < mode_count; ++k)
    for (Eigen::Index i = 0; i < size; ++i)
      motions(i, k) =
          std::sin(1.0 + static_cast<double>(k) + 0.7 * static_cast<double>(i * (k + 1)));
  return motions;
}

}  // namespace

Eigen::VectorXd lumped_mass(const System& system) {
  const auto rods = static_cast<Eigen::Index>(system.structure().rods.size());
  return lumped_mass(system, Eigen::VectorXd::Ones(rods));
}

Eigen::VectorXd lumped_mass(const System& system, const Eigen::VectorXd& mass_per_length) {
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(system.size());
  const auto& rods = system.structure().rods;
  for (int r = 0; r < static_cast<int>(rods.size()); ++r)
    for (int j = 0; j < rods[r].edges(); ++j)
      for (const int v : {j, (j + 1) % rods[r].vertices()})
        for (int axis = 0; axis < 3; ++axis)
          if (const int i = system.position_index(r, v, axis); i >= 0)
            mass[i] += mass_per_length[r] * rods[r].rest_lengths[j] / 2;
  return mass;
}

double eigenvalue_unit(const model::Structure& structure) {
  double bending = 0;
  for (const auto& rod : structure.rods)
    bending = std::max({bending, rod.section.EI1, rod.section.EI2});
  return bending / std::pow(model::total_length(structure), 4);
}

linalg::SymmetricMatrix shifted(const System& system, linalg::SymmetricMatrix matrix,
                                double limit) {
  const Eigen::VectorXd shift = limit * eigenvalue_unit(system.structure()) * lumped_mass(system);
  for (int i = 0; i < matrix.cols(); ++i) matrix.coeffRef(i, i) -= shift[i];
  return matrix;
}

bool stiffer_than(const System& system, const Linearisation& at, double limit,
                  linalg::SymmetricFactor& workspace) {
  if (limit <= 0) return at.regular && at.negative == 0;
  return workspace.factorise(shifted(system, at.matrix, limit)) &&
         workspace.inertia().negative == system.saddle_unknowns();
}

SoftModes soft_modes(const System& system, const Linearisation& at, const SoftModes& nearby) {
  const bool known = nearby.modes.rows() == system.size();
  SoftModes result{.modes = known ? nearby.modes : any_motions(system.size())};
  const Eigen::VectorXd mass = lumped_mass(system);
  const double unit = eigenvalue_unit(system.structure());
  for (int round = 0; round < (known ? 2 : 12); ++round) {
    Eigen::MatrixXd force = mass.asDiagonal() * result.modes;
    for (Eigen::Index k = 0; k < force.cols(); ++k) remove_rigid(at.rigid, force.col(k));
    const Eigen::MatrixXd motion = at.solve(force);
    // H motion = force, so this is the Rayleigh-Ritz problem of H and M on the motions.
    const Eigen::MatrixXd stiffness = motion.transpose() * force;
    const Eigen::MatrixXd inertia = motion.transpose() * mass.asDiagonal() * motion;
    const linalg::Eigenpairs ritz = linalg::symmetric_eigenpairs(
        (stiffness + stiffness.transpose()) / 2, (inertia + inertia.transpose()) / 2);
    if (!ritz.converged || !ritz.values.allFinite())
      return {.modes = {}, .values = Eigen::VectorXd::Constant(mode_count, -1)};
    result.modes = motion * ritz.vectors;
    result.values = ritz.values / unit;
  }
  return result;
}

}  // namespace tencer::equilibrium
