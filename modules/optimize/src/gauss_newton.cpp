#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/optimize/evaluator.hpp>
#include <tencer/optimize/gauss_newton.hpp>
#include <vector>

namespace tencer::optimize {
namespace {

// The damped step on the free parameters; empty when the damped matrix is not positive definite.
Eigen::VectorXd damped_step(const Problem& problem, const Eigen::VectorXd& p,
                            const Eigen::VectorXd& g, const Eigen::MatrixXd& h, double damping) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < p.size(); ++i)
    if (!(p[i] <= problem.lower[i] && g[i] > 0) && !(p[i] >= problem.upper[i] && g[i] < 0))
      free.push_back(i);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(p.size());
  if (free.empty()) return step;
  Eigen::MatrixXd matrix = h(free, free);
  // The second only matters to a matrix with little on its diagonal, and then it is indefinite.
  const double typical = std::max(matrix.diagonal().cwiseAbs().mean(),
                                  matrix.cwiseAbs().maxCoeff() / static_cast<double>(free.size()));
  const double min_diagonal = typical > 0 ? 1e-3 * typical : 1;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    matrix(i, i) += damping * std::max(std::abs(matrix(i, i)), min_diagonal);
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  if (factor.info() != Eigen::Success) return {};
  const Eigen::VectorXd slope = g(free);
  step(free) = -factor.solve(slope);
  return step;
}

Report minimise(const Problem& problem, const Eigen::VectorXd& start, const Options& options) {
  core::require(problem.hessian != nullptr, "minimise: gauss-newton needs Problem::hessian");
  constexpr double min_damping = 1e-6;
  constexpr double max_damping = 1e6;
  Evaluator evaluator(problem, start, options);
  Eigen::VectorXd p = evaluator.start();
  Eigen::VectorXd g;
  Eigen::MatrixXd h;
  double damping = 1e-2;
  double step_limit = options.initial_step;  // a limited step rather than a refused one
  while (!evaluator.finished() && evaluator.gradient(p, g)) {
    if (!evaluator.hessian(p, h)) return evaluator.finish("no Hessian at the last point");
    const double value = evaluator.value(p).value();
    bool moved = false;
    while (!moved && damping <= max_damping && !evaluator.finished()) {
      Eigen::VectorXd step = damped_step(problem, p, g, h, damping);
      if (step.size() > 0) {
        const double length = step.lpNorm<Eigen::Infinity>();
        if (length > step_limit) step *= step_limit / length;
        const Eigen::VectorXd next = (p + step).cwiseMax(problem.lower).cwiseMin(problem.upper);
        const auto there = evaluator.value(next);
        if (!there) step_limit = 0.5 * (next - p).lpNorm<Eigen::Infinity>();
        moved = there && *there < value;
        if (moved) p = next;
      }
      damping = moved ? std::max(damping / 5, min_damping) : 4 * damping;
    }
    if (!moved || !evaluator.gradient(p, g)) break;
    evaluator.accept(p);
    step_limit *= 2;
  }
  return evaluator.finish();
}

}  // namespace

Backend gauss_newton() {
  return {.name = "gauss-newton",
          .description = "bounded Levenberg-Marquardt, supplied Hessian",
          .uses_hessian = true,
          .minimise = minimise};
}

}  // namespace tencer::optimize
