// The last fit of a network as a problem for an outer optimizer.
#pragma once

#include <limits>
#include <optional>
#include <tencer/optimize/problem.hpp>

#include "state/fitted_network.hpp"

namespace tencer::elimination {

// The variables p (P) are those of the network's local model when the fit begins, less their values
// there: rest lengths and attachments in units of an edge. The stiffness of the cables stays, so
// rest lengths stand for force densities; attachments keep to the rules, and all variables within
// max_slide edges. Value, gradient and Gauss-Newton Hessian are those of the network's objective at
// the equilibrium that is followed from the last point that move_to() was told of.
class FitProblem {
 public:
  // Refers to the network, which must be usable and have cables.
  FitProblem(FittedNetwork& fitted, double max_slide);

  // Refers to this object.
  optimize::Problem problem();
  Eigen::VectorXd start() const { return Eigen::VectorXd::Zero(base_.size()); }
  void move_to(const Eigen::VectorXd& p);

  // Leaves the network where its objective is the lowest of all evaluated, its cables as good as
  // inextensible again.
  void finish();

 private:
  bool evaluate(const Eigen::VectorXd& p);

  FittedNetwork& fitted_;
  GaussNewtonModel model_;              // at base_
  std::vector<springs::Cable> cables_;  // at p = 0
  Eigen::VectorXd scale_;               // per variable, the edge
  Eigen::VectorXd lower_, upper_;
  Eigen::VectorXd base_;         // the point where the network is
  Eigen::VectorXd last_;         // the point of the trial
  std::optional<double> value_;  // there; none where it failed
  std::optional<network::Network> best_;
  double best_value_ = std::numeric_limits<double>::infinity();
};

}  // namespace tencer::elimination
