// Sizes of forces and steps that Newton's method steers by.
#pragma once

#include <Eigen/Core>
#include <tencer/equilibrium/system.hpp>

namespace tencer::equilibrium {

// The largest over all rods of |gradient| / (|gradient of the rod alone| + EI / L^2), each over the
// rod's own unknowns: a soft rod beside a stiff one has to be in balance by its own measure.
// rod_gradient is the system's, with loads.
double relative_residual(const System& system, const Eigen::VectorXd& gradient,
                         const Eigen::VectorXd& rod_gradient);

// The same of what is left of each rod's |gradient| when `explained`, a force per rod, is taken off
// it.
double relative_residual(const System& system, const Eigen::VectorXd& gradient,
                         const Eigen::VectorXd& rod_gradient, const Eigen::VectorXd& explained);

struct ForceBalance {
  Eigen::VectorXd gradient;
  double residual = 0.0;
};
ForceBalance force_balance(const System& system, const model::State& state);

// Per rod, the norm of what rounding of the vertices' coordinates does to the gradient: eps |x|
// times EA / l per edge, 8 EI / l^3 per bend, k per cable.
Eigen::VectorXd gradient_rounding(const System& system, const model::State& state);

// Whether, on every rod, the gradient is no larger than that.
bool is_rounding(const System& system, const model::State& state, const Eigen::VectorXd& gradient);

// What the same rounding does to the energy: it moves edges and bends against the forces and
// moments that they carry.
double energy_rounding(const System& system, const model::State& state);

// What rounding of the entries of H, of this diagonal, can do to d^T H d.
double curvature_rounding(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& d);

// Per free unknown, the order of its stiffness in the softest bending mode of its rod: EI / L^3 for
// coordinates, EI / L for twist; 0 for twisting moments.
Eigen::VectorXd softest_stiffness(const System& system);
// Per free unknown, the order of the stiffness of an edge of its rod: for coordinates the geometric
// mean of EA / l and EI / l^3, along and across; EI / l for twist; 0 for twisting moments.
Eigen::VectorXd edge_stiffness(const System& system);

// Largest motion of a vertex under a step.
double largest_motion(const System& system, const Eigen::VectorXd& step);

// Largest change of an edge under a step, relative to its length.
double largest_rotation(const System& system, const model::State& state,
                        const Eigen::VectorXd& step);

}  // namespace tencer::equilibrium
