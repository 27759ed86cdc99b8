// Newton's method for a structure's stable equilibrium (paper section 4, eq. 5; section 5.3,
// "Equilibrium conditions").
#pragma once

#include <limits>
#include <optional>
#include <stop_token>
#include <string>
#include <tencer/equilibrium/rigid_modes.hpp>
#include <tencer/equilibrium/system.hpp>
#include <tencer/linalg/symmetric_factor.hpp>
#include <vector>

namespace tencer::equilibrium {

// The factorised Hessian at a state, anchored against rigid motion; also the workspace of solve(),
// which keeps the symbolic analysis from one solve to the next.
struct Linearisation {
  linalg::SymmetricFactor factor{};
  linalg::SymmetricMatrix matrix{};
  std::vector<RigidModes> rigid{};
  int negative = 0;      // negative eigenvalues apart from the system's saddle unknowns
  bool regular = false;  // false: singular, nothing may be solved with it

  // H^+ b for b without rigid part (the gradient of anything that rigid motion leaves alone); the
  // result has no rigid part either. b: size x k.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
};

// Factorises the Hessian at `state` into `at`.
void linearise(const System& system, const model::State& state, Linearisation& at);
// The same with these forces in the geometric stiffness, see System::hessian.
void linearise(const System& system, const model::State& state, const InternalForces& forces,
               Linearisation& at);

struct SolveOptions {
  double tolerance = 1e-10;   // on the residual, see Equilibrium
  double max_turn = 1e-9;     // of an edge (radians) by the step that would follow
  int max_iterations = 500;   // steps of Newton's method
  double max_rotation = 0.2;  // largest change of an edge in one step, relative to its length
  int patience = 24;          // steps that may pass without a lower energy before a line search
  // Ends when the largest turns of an edge, added up over the steps, exceed this (in radians,
  // about): for those who look for an equilibrium near the start, or none.
  double max_path_rotation = std::numeric_limits<double>::infinity();
  // The forces in edges and cables, where they are known better than by the start's lengths: a
  // change of shape predicted to first order leaves stiff edges far from the forces they will have.
  std::optional<InternalForces> forces{};
  std::stop_token stop{};
};

enum class Reason {
  converged,  // residual below tolerance, no direction of negative curvature
  rounding,   // the same, but rounding keeps the residual above the tolerance
  saddle,     // forces in balance at an unstable state that could not be left
  neutral,    // forces in balance, but some motion other than a rigid one costs nothing, or no more
              // than rounding
  uncertain,  // forces in balance as far as rounding allows, which leaves edges free to turn by
              // more than 1e-6 and max_turn
  iteration_limit,
  path_limit,  // SolveOptions::max_path_rotation was reached
  no_descent,  // no step lowers the energy although forces are not in balance
  not_held,    // a load on rods that no support holds against it
  not_finite,  // the starting state has infinite or undefined energy
  stopped
};

struct Equilibrium {
  model::State state{};  // the best state found, also when the solve failed
  Reason reason = Reason::iteration_limit;
  double residual = 0.0;  // |gradient| / (|gradient of the rods| + EI / L^2), of the worst rod
  double energy = 0.0;
  int iterations = 0;
  int factorisations = 0;
  int evaluations = 0;  // of energy and gradient
  int escapes = 0;      // steps along negative curvature, off a saddle or maximum
  int negative = 0;     // negative eigenvalues of the Hessian at `state`, once forces balance

  bool usable() const { return reason == Reason::converged || reason == Reason::rounding; }
};

// One sentence that says why the solve stopped.
std::string describe(Reason reason);

// Minimises the energy from `start`. `workspace` holds the linearisation at the result afterwards
// when the result is usable.
//
// Steps are those of the mixed formulation, in which the forces of edges and cables are unknowns of
// their own (eliminated edge by edge): the geometric stiffness uses forces predicted by the last
// step. Stretching hardly slows it, however slender the rods. Steps that raise the energy are
// allowed for a while (a watchdog: `patience`), then undone by a line search.
Equilibrium solve(const System& system, model::State start, const SolveOptions& options,
                  Linearisation& workspace);
Equilibrium solve(const System& system, model::State start, const SolveOptions& options = {});

// |gradient| relative to the rods' internal force, as in Equilibrium::residual.
double residual(const System& system, const model::State& state);

}  // namespace tencer::equilibrium
