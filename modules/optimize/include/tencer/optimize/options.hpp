// When an optimizer stops and how boldly it starts; the same for every backend. Parameters and
// values are in the problem's own units, of order one (see Problem).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <stop_token>

namespace tencer::optimize {

enum class Curvature {
  limited_memory,  // estimated from gradients
  supplied         // Problem::hessian, by backends that say uses_hessian; others ignore it
};

// Where a run is after each iterate its method accepted.
struct Progress {
  int iteration = 0;
  int evaluations = 0;
  double seconds = 0.0;
  double value = 0.0;
  double projected_gradient = 0.0;  // largest entry
  const Eigen::VectorXd& point;
};

struct Options {
  int max_evaluations = 2000;  // of the value; judging the best point may take one more
  int max_iterations = 1000;   // iterates accepted

  // Converged when no entry of the projected gradient exceeds this times max(1, |value|).
  double gradient_tolerance = 1e-6;
  // Small progress when the last 8 accepted values differ by no more than this times
  // max(1, |value|).
  double value_tolerance = 1e-10;

  // The largest change of a parameter before the first accepted iterate (the paper's trust radius,
  // section 5). The limit doubles with each accepted iterate, so that it tames the start and does
  // not hold back what follows; a trial without a value halves its own distance. Trials beyond the
  // limit are refused without being evaluated, since those that fail are the dearest.
  double initial_step = std::numeric_limits<double>::infinity();

  Curvature curvature = Curvature::limited_memory;

  std::stop_token stop{};  // asked before each evaluation
  // Called in the thread of the minimisation, with what is gone when it returns. May be empty; what
  // it throws ends the run and comes out of minimise.
  std::function<void(const Progress&)> progress{};

  // Throws std::invalid_argument naming the option that is wrong.
  void validate() const;
};

}  // namespace tencer::optimize
