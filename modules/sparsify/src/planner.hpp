// Steps of a network's variables that bring it closer to its target, cables going slack if asked.
#pragma once

#include <utility>

#include "local_model.hpp"

namespace tencer::sparsify {

// What is made small: distances from the target in units of `unit` (a length), as their mean of
// this power: 2 is the root mean square, a large one nearly the maximum.
struct Aim {
  double unit = 1.0;
  double power = 2.0;
};

// (mean of |r_i|^power)^(2 / power) of the vertices' residuals r_i (3 entries each), in units of
// `unit`.
double mismatch(const Eigen::VectorXd& residual, const Aim& aim);

// Linear constraints rows z >= least on a step z; the first O are the orbits' force densities.
struct StepBounds {
  Eigen::MatrixXd rows{};
  Eigen::VectorXd least{};
};

// Further squares |value + rates z|^2 in the objective.
struct Squares {
  Eigen::VectorXd value{};
  Eigen::MatrixXd rates{};
};

class Planner {
 public:
  // damping: what the square of each variable costs, Z.
  Planner(LocalModel model, const Aim& aim, const Squares& further, const Eigen::VectorXd& damping,
          StepBounds bounds);

  const LocalModel& model() const { return model_; }

  // Per orbit, the objective that is predicted once its force density is zero and all other
  // variables are refitted.
  Eigen::VectorXd removal_costs() const;

  // The best step within the bounds, times `part`, that takes the force densities of the orbits
  // `out` to zero, times `part`. Not finite when the model is not.
  Eigen::VectorXd step(const std::vector<int>& out, double part = 1.0) const;

  // How much one variable more would lower the objective, all others refitted, and its best value;
  // residual_rates: of the residual in it. Zeros when it would have to be negative.
  std::pair<double, double> gain(const Eigen::VectorXd& residual_rates) const;

 private:
  LocalModel model_;
  StepBounds bounds_;
  double radial_ = 1.0;       // extra weight of a residual's own direction
  Eigen::VectorXd roots_;     // weight of each vertex
  Eigen::VectorXd residual_;  // weighted
  Eigen::MatrixXd jacobian_;  // weighted
  Eigen::MatrixXd inverse_;   // of the damped normal matrix
  Eigen::VectorXd step_;      // without bounds
};

}  // namespace tencer::sparsify
