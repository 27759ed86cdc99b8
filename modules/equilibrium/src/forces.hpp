// Sizes of forces and steps that Newton's method steers by.
#pragma once

#include <Eigen/Core>
#include <tencer/equilibrium/system.hpp>

namespace tencer::equilibrium {

// |gradient| / (|gradient of the rods alone| + max EI / L^2); rod_gradient is the system's, with
// loads.
double relative_residual(const System& system, const Eigen::VectorXd& gradient,
                         const Eigen::VectorXd& rod_gradient);

struct ForceBalance {
  Eigen::VectorXd gradient;
  double residual = 0.0;
};
ForceBalance force_balance(const System& system, const State& state);

// What rounding of the vertices' coordinates does to the gradient's norm: eps |x| EA / l per edge
// and eps |x| k per cable.
double gradient_rounding(const System& system, const State& state);

// The largest EI of all rods.
double largest_bending(const Structure& structure);

// EI / L^3, the order of the force per displacement of a vertex in the softest bending mode.
double softest_stiffness(const Structure& structure);

// Largest change of an edge under a step, relative to its length.
double largest_rotation(const System& system, const State& state, const Eigen::VectorXd& step);

// Forces of edges and cables after a step, by linearisation at `state`.
InternalForces predicted_forces(const System& system, const State& state,
                                const Eigen::VectorXd& step);

}  // namespace tencer::equilibrium
