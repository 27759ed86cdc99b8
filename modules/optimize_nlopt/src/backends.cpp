#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <tencer/optimize/evaluator.hpp>
#include <tencer/optimize_nlopt/backends.hpp>
#include <type_traits>

namespace tencer::optimize_nlopt {
namespace {

using optimize::Evaluator;
using optimize::Options;
using optimize::Problem;
using optimize::Report;

// The C interface: the C++ one turns exceptions into messages and throws its own.
using Optimizer = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, decltype(&nlopt_destroy)>;

struct Run {
  Evaluator& evaluator;
  nlopt_opt optimizer;
  double lowest = std::numeric_limits<double>::infinity();
};

double value_and_gradient(unsigned n, const double* x, double* gradient, void* data) {
  Run& run = *static_cast<Run*>(data);
  const Eigen::Map<const Eigen::VectorXd> p(x, n);
  // HUGE_VAL makes these methods shorten their step; NaN would spin or end in a false success.
  double result = HUGE_VAL;
  const auto value = run.evaluator.value(p);
  // They only move to lower values, and only then look at the gradient.
  if (value && *value >= run.lowest) result = *value;
  Eigen::VectorXd g = Eigen::VectorXd::Zero(n);
  if (value && *value < run.lowest && run.evaluator.gradient(p, g)) {
    result = run.lowest = *value;
    run.evaluator.accept(p);
  }
  if (gradient != nullptr) Eigen::Map<Eigen::VectorXd>(gradient, n) = g;
  if (run.evaluator.finished()) nlopt_force_stop(run.optimizer);
  return result;
}

std::string breakdown(nlopt_result result) {
  const bool in_order =
      result > 0 || result == NLOPT_FORCED_STOP || result == NLOPT_ROUNDOFF_LIMITED;
  return in_order ? std::string() : std::string("NLopt: ") + nlopt_result_to_string(result);
}

Report minimise(nlopt_algorithm algorithm, const Problem& problem, const Eigen::VectorXd& start,
                const Options& options) {
  Evaluator evaluator(problem, start, options);
  if (evaluator.finished()) return evaluator.finish();
  const Optimizer optimizer(nlopt_create(algorithm, static_cast<unsigned>(problem.size())),
                            nlopt_destroy);
  Run run{.evaluator = evaluator, .optimizer = optimizer.get()};
  nlopt_set_min_objective(run.optimizer, value_and_gradient, &run);
  nlopt_set_lower_bounds(run.optimizer, problem.lower.data());
  nlopt_set_upper_bounds(run.optimizer, problem.upper.data());
  // The evaluator judges convergence and counts; this ends a run that asks for the same point, or
  // for steps too long to be evaluated, for ever.
  nlopt_set_maxeval(run.optimizer,
                    std::min(options.max_evaluations, std::numeric_limits<int>::max() / 20) * 20);
  nlopt_set_xtol_abs1(run.optimizer, 1e-14);
  // Without a limit the search for a conservative model may go on at one iterate for ever.
  nlopt_set_param(run.optimizer, "inner_maxeval", 10);
  Eigen::VectorXd x = evaluator.start();
  double value = 0.0;
  const nlopt_result result = nlopt_optimize(run.optimizer, x.data(), &value);
  return evaluator.finish(breakdown(result));
}

optimize::Backend backend(const char* name, const char* description, nlopt_algorithm algorithm) {
  return {.name = name,
          .description = description,
          .uses_hessian = false,
          .minimise = [algorithm](const Problem& problem, const Eigen::VectorXd& start,
                                  const Options& options) {
            return minimise(algorithm, problem, start, options);
          }};
}

}  // namespace

std::vector<optimize::Backend> backends() {
  return {backend("mma", "method of moving asymptotes (NLopt)", NLOPT_LD_MMA),
          backend("ccsaq", "conservative convex separable quadratic approximations (NLopt)",
                  NLOPT_LD_CCSAQ)};
}

}  // namespace tencer::optimize_nlopt
