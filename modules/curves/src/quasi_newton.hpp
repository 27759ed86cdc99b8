// Limited-memory quasi-Newton directions for curves, with a metric of their own to start from.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <utility>

namespace tencer::curves {

// The inverse Hessian as it shows in the last steps (L-BFGS, Nocedal 1980).
class QuasiNewton {
 public:
  // inverse_metric: n x n, symmetric, acts on each coordinate of n vertices alike; scaled to fit.
  explicit QuasiNewton(Eigen::MatrixXd inverse_metric) : metric_(std::move(inverse_metric)) {}

  // The step that would reach the minimum, as far as is known; 3 x n.
  Eigen::Matrix3Xd direction(const Eigen::Matrix3Xd& gradient) const;

  // Whether direction() knows how long its steps are.
  bool scaled() const { return !steps_.empty(); }

  // Takes note of a step and of the gradient's change, unless it shows no positive curvature.
  void learn(const Eigen::Matrix3Xd& step, const Eigen::Matrix3Xd& change);

  void forget() { steps_.clear(); }

 private:
  struct Step {
    Eigen::Matrix3Xd step;
    Eigen::Matrix3Xd change;
    double curvature;  // step . change
  };

  Eigen::MatrixXd metric_;
  std::deque<Step> steps_;
};

}  // namespace tencer::curves
