#include "levenberg.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <tencer/optimize/evaluator.hpp>
#include <vector>

namespace tencer::sparsify {
namespace {

// The damped step on the free variables; empty when the damped matrix is not positive definite.
Eigen::VectorXd damped_step(const optimize::Problem& problem, const Eigen::VectorXd& p,
                            const Eigen::VectorXd& g, const Eigen::MatrixXd& h, double damping) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < p.size(); ++i)
    if (!(p[i] <= problem.lower[i] && g[i] > 0) && !(p[i] >= problem.upper[i] && g[i] < 0))
      free.push_back(i);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(p.size());
  if (free.empty()) return step;
  Eigen::MatrixXd matrix = h(free, free);
  const double typical = matrix.diagonal().cwiseAbs().mean();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    matrix(i, i) += damping * std::max(std::abs(matrix(i, i)), 1e-3 * typical);
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  if (factor.info() != Eigen::Success) return {};
  const Eigen::VectorXd slope = g(free);
  step(free) = -factor.solve(slope);
  return step;
}

optimize::Report minimise(const optimize::Problem& problem, const Eigen::VectorXd& start,
                          const optimize::Options& options) {
  constexpr double least = 1e-6;
  constexpr double most = 1e6;
  optimize::Evaluator evaluator(problem, start, options);
  Eigen::VectorXd p = evaluator.start();
  Eigen::VectorXd g;
  Eigen::MatrixXd h;
  double damping = 1e-2;
  while (!evaluator.finished() && evaluator.gradient(p, g) && evaluator.hessian(p, h)) {
    const double value = evaluator.value(p).value();
    bool moved = false;
    while (!moved && damping <= most && !evaluator.finished()) {
      Eigen::VectorXd step = damped_step(problem, p, g, h, damping);
      if (step.size() > 0) {
        // A limited step rather than a refused one.
        const double longest = step.lpNorm<Eigen::Infinity>();
        if (longest > options.first_step) step *= options.first_step / longest;
        const Eigen::VectorXd next = (p + step).cwiseMax(problem.lower).cwiseMin(problem.upper);
        const auto there = evaluator.value(next);
        moved = there && *there < value;
        if (moved) p = next;
      }
      damping = moved ? std::max(damping / 5, least) : 4 * damping;
    }
    if (!moved) break;
    if (!evaluator.gradient(p, g)) break;
    evaluator.accept(p);
  }
  return evaluator.finish();
}

}  // namespace

optimize::Backend levenberg() {
  return {.name = "levenberg",
          .description = "bounded Levenberg method",
          .uses_hessian = true,
          .minimise = minimise};
}

}  // namespace tencer::sparsify
