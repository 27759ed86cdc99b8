// Mass and units for questions about the softest motions of a structure.
#pragma once

#include <Eigen/Core>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/system.hpp>
#include <tencer/linalg/symmetric_factor.hpp>

namespace tencer::equilibrium {

// Mass of the free unknowns (size) for one unit of mass per rod length, lumped at the vertices; 0
// for what is not a position.
Eigen::VectorXd lumped_mass(const System& system);
// The same with a mass per length at rest for every rod.
Eigen::VectorXd lumped_mass(const System& system, const Eigen::VectorXd& mass_per_length);

// max EI / L^4, L the rods' total length: the unit in which Stability tells eigenvalues.
double eigenvalue_unit(const model::Structure& structure);

// matrix - limit M, with the limit in eigenvalue_unit: its inertia counts the eigenvalues below the
// limit. `matrix` is the Hessian, usually stabilised against rigid motion.
linalg::SymmetricMatrix shifted(const System& system, linalg::SymmetricMatrix matrix, double limit);

// Whether all eigenvalues apart from rigid motion exceed `limit`, by one factorisation. at: of the
// system at a state. `workspace` keeps the symbolic analysis from call to call.
[[nodiscard]] bool stiffer_than(const System& system, const Linearisation& at, double limit,
                                linalg::SymmetricFactor& workspace);

// modes: size x 3 with modes^T M modes = 1; values: their Rayleigh quotients, ascending, in
// eigenvalue_unit: upper bounds of the eigenvalues they approach.
struct SoftModes {
  Eigen::MatrixXd modes{};
  Eigen::VectorXd values{};
};

// The softest three by a few steps of subspace iteration with the factor at hand, from `nearby`
// (which may be empty). Values are positive at stable configurations only; -1 where the iteration
// broke down.
[[nodiscard]] SoftModes soft_modes(const System& system, const Linearisation& at,
                                   const SoftModes& nearby);

}  // namespace tencer::equilibrium
