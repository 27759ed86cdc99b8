// The damped Gauss-Newton model of a network's objective: the steps that lower it most, cables
// going slack if asked, and what the loss or gain of a cable would do to it.
#pragma once

#include "model/local_model.hpp"

namespace tencer::elimination {

// What is made small: distances from the target in units of `unit` (a length), as their mean of
// this power: 2 is the root mean square, a large one nearly the maximum.
struct Norm {
  double unit = 1.0;
  double power = 2.0;
};

// (mean of |r_i|^power)^(2 / power) of the vertices' residuals r_i (3 entries each), in units of
// norm.unit.
double mismatch(const Eigen::VectorXd& residual, const Norm& norm);

// Linear constraints rows z >= lower on a step z; the first O are the orbits' force densities.
struct StepBounds {
  Eigen::MatrixXd rows{};
  Eigen::VectorXd lower{};
};

// Further squares |value + rates z|^2 in the objective.
struct Squares {
  Eigen::VectorXd value{};
  Eigen::MatrixXd rates{};
};

class GaussNewtonModel {
 public:
  // damping: what the square of each variable costs, Z.
  GaussNewtonModel(LocalModel local, const Norm& norm, const Squares& further,
                   const Eigen::VectorXd& damping, StepBounds bounds);

  const LocalModel& local() const { return local_; }

  // The objective's derivative in the variables (Z), and its Gauss-Newton approximation (Z x Z).
  Eigen::VectorXd gradient() const { return 2 * (jacobian_.transpose() * residual_); }
  Eigen::MatrixXd hessian() const { return 2 * (jacobian_.transpose() * jacobian_); }

  // Per orbit, the objective that is predicted once its force density is zero and all other
  // variables are refitted: the saliency of the optimal brain surgeon (Hassibi and Stork 1993, eq.
  // 5), exact for this model without bounds and damping.
  Eigen::VectorXd removal_costs() const;

  // The best step within the bounds, times `part`, that takes the force densities of the orbits
  // `out` to zero, times `part`. Not finite when the model is not.
  Eigen::VectorXd step(const std::vector<int>& out, double part = 1.0) const;

  struct Gain {
    double value = 0.0;  // how much lower the objective would be, all other variables refitted
    double at = 0.0;     // the new variable's best value
  };
  // What one variable more would bring, in which the residual's rates are residual_rates (3 per
  // vertex). Zeros when the variable would have to be negative.
  Gain gain(const Eigen::VectorXd& residual_rates) const;

 private:
  LocalModel local_;
  StepBounds bounds_;
  double radial_ = 1.0;       // extra weight of a residual's own direction
  Eigen::VectorXd roots_;     // weight of each vertex
  Eigen::VectorXd residual_;  // weighted
  Eigen::MatrixXd jacobian_;  // weighted
  Eigen::MatrixXd inverse_;   // of the damped normal matrix
  Eigen::VectorXd step_;      // without bounds
};

}  // namespace tencer::elimination
