// The motions that a structure resists least, followed from one network to the next.
#pragma once

#include <Eigen/Core>
#include <Eigen/Sparse>
#include <span>
#include <tencer/sensitivity/parameters.hpp>
#include <tencer/sensitivity/tracker.hpp>

namespace tencer::sparsify {

// Mass of the free unknowns for one unit of mass per rod length; 0 for what is not a position.
Eigen::VectorXd lumped_mass(const equilibrium::System& system);

// max EI / L^4, the unit of equilibrium::Stability's eigenvalues.
double eigenvalue_unit(const equilibrium::System& system);

// modes: size x 3 with modes^T M modes = 1; values: their Rayleigh quotients, ascending, in
// eigenvalue_unit(): not below the eigenvalues they approach.
struct SoftModes {
  Eigen::MatrixXd modes{};
  Eigen::VectorXd values{};
};

// A few steps of subspace iteration with the factor at hand, from `nearby` (which may be empty).
// Positive values are found only at stable configurations.
SoftModes soft_modes(const sensitivity::Configuration& at, const SoftModes& nearby);

// d(value)/dz of mode k, exact, for parameters p = p0 + ties z; motion: dx/dz (size x Z).
Eigen::VectorXd soft_rates(const sensitivity::Configuration& at, const SoftModes& soft,
                           Eigen::Index k, std::span<const sensitivity::Parameter> parameters,
                           const Eigen::SparseMatrix<double>& ties, const Eigen::MatrixXd& motion);

}  // namespace tencer::sparsify
