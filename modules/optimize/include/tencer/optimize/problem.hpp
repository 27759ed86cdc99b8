// The problem an outer optimizer solves: minimise a smooth function of P parameters between bounds.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace tencer::optimize {

// Scaled by the caller so that the parameters and the value are of order one: no method rescales
// them, and tolerances are stated in these units.
struct Problem {
  Eigen::VectorXd lower,
      upper;  // P each, lower <= upper, may be infinite; equal: a fixed parameter

  // The functions are only called with p (P) between the bounds, one at a time and in the thread of
  // the minimisation; what they throw ends it and comes out of minimise. gradient and
  // hessian are only called at the p at which value was called last, and succeeded. They must give
  // the same answer for the same p whatever was evaluated before.
  //
  // nullopt (or a value that is not finite) where the problem cannot be evaluated, say because an
  // equilibrium is lost: methods then shorten their step. Such places must be told here; a gradient
  // or Hessian that fails where the value succeeded may end the run.
  std::function<std::optional<double>(const Eigen::VectorXd& p)> value;
  // g: P, resized by the callee. False when it cannot be computed.
  std::function<bool(const Eigen::VectorXd& p, Eigen::VectorXd& g)> gradient;
  // h: P x P, symmetric, exact or an approximation such as Gauss-Newton. May be empty.
  std::function<bool(const Eigen::VectorXd& p, Eigen::MatrixXd& h)> hessian;

  Eigen::Index size() const { return lower.size(); }

  // Throws std::invalid_argument naming what is wrong.
  void validate() const;
};

// The gradient g (P) with what the bounds hold back at p (P) taken off: the step p - clamp(p - g)
// of unit steepest descent, zero exactly at the points that satisfy the first-order conditions.
Eigen::VectorXd projected_gradient(const Problem& problem, const Eigen::VectorXd& p,
                                   const Eigen::VectorXd& g);

}  // namespace tencer::optimize
