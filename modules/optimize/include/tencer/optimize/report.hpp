// What came of a minimisation and why it ended.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

namespace tencer::optimize {

enum class Reason {
  converged,         // the projected gradient at the best point is within its tolerance
  small_progress,    // the value no longer changes, or the method found no better point
  evaluation_limit,  // Options::max_evaluations
  iteration_limit,   // Options::max_iterations
  stopped,           // Options::stop
  lost,   // the start has no value, or most of what was tried since the best point; at the
          // latest after 50 failures
  failed  // the method broke down
};

struct Improvement {
  int evaluation = 0;  // counted from 1
  double seconds = 0.0;
  double value = 0.0;
};

struct [[nodiscard]] Report {
  Reason reason = Reason::failed;
  bool usable = false;  // point has a value, the lowest of all that were evaluated

  Eigen::VectorXd point;  // P, between the bounds
  double value = std::numeric_limits<double>::infinity();
  // Largest entry at `point`, computed here and not by the backend; infinite when its gradient
  // could not be computed.
  double projected_gradient = std::numeric_limits<double>::infinity();

  int iterations = 0;
  int evaluations = 0;  // calls of Problem::value, the failed ones included
  int failed_evaluations = 0;
  int gradients = 0;
  int hessians = 0;
  double seconds = 0.0;
  std::vector<Improvement> history;  // each new best value, the start's first

  std::string message;  // one sentence
};

}  // namespace tencer::optimize
