#include <tencer/core/error.hpp>
#include <tencer/optimize/problem.hpp>

namespace tencer::optimize {

void Problem::validate() const {
  core::require(size() > 0, "Problem: needs at least one parameter");
  core::require(upper.size() == size(), "Problem: lower and upper differ in size");
  // Also false for NaN.
  core::require((lower.array() <= upper.array()).all(), "Problem: needs lower <= upper");
  core::require(value != nullptr && gradient != nullptr, "Problem: needs value and gradient");
}

Eigen::VectorXd projected_gradient(const Problem& problem, const Eigen::VectorXd& p,
                                   const Eigen::VectorXd& g) {
  return p - (p - g).cwiseMax(problem.lower).cwiseMin(problem.upper);
}

}  // namespace tencer::optimize
