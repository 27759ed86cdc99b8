#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <tencer/core/error.hpp>
#include <tencer/optimize/evaluator.hpp>

namespace tencer::optimize {
namespace {

constexpr std::size_t level_window = 8;
// A line search that fails takes a dozen; some methods would go on to their iteration limit.
constexpr int max_failures_in_vain = 50;

Eigen::VectorXd between_bounds(const Problem& problem, const Eigen::VectorXd& p) {
  return p.cwiseMax(problem.lower).cwiseMin(problem.upper);
}

const char* phrase(Reason reason) {
  switch (reason) {
    case Reason::converged:
      return "converged";
    case Reason::small_progress:
      return "no further progress";
    case Reason::evaluation_limit:
      return "the evaluation limit was reached";
    case Reason::iteration_limit:
      return "the iteration limit was reached";
    case Reason::stopped:
      return "stopped on request";
    case Reason::lost:
      return "ended where most points around the best one cannot be evaluated";
    case Reason::failed:
      return "the method broke down";
  }
  return "";
}

}  // namespace

Evaluator::Evaluator(const Problem& problem, const Eigen::VectorXd& start, const Options& options)
    : problem_(problem), options_(options), step_limit_(options.initial_step) {
  problem.validate();
  options.validate();
  core::require(start.size() == problem.size() && start.allFinite(),
                "minimise: the start must be finite and of the problem's size");
  core::require(options.curvature != Curvature::supplied || problem.hessian != nullptr,
                "minimise: Curvature::supplied needs Problem::hessian");
  start_ = between_bounds(problem, start);
  iterate_ = start_;
  best_.p = start_;
  Eigen::VectorXd g;
  if (gradient(start_, g)) {
    accepted_values_.push_back(*last_.value);
    if (slope(last_) <= options.gradient_tolerance * std::max(1.0, std::abs(*last_.value)))
      reason_ = Reason::converged;
  } else if (!finished()) {
    reason_ = Reason::lost;
  }
}

double Evaluator::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

// The one place where exceptions are caught: solvers written in C or Fortran, and those that turn
// exceptions into messages, must not see them.
void Evaluator::guarded(const std::function<void()>& call) {
  try {
    call();
  } catch (...) {
    exception_ = std::current_exception();
  }
}

void Evaluator::evaluate(const Eigen::VectorXd& p) {
  last_ = {.p = p, .value = {}, .gradient = {}};
  ++report_.evaluations;
  guarded([&] { last_.value = problem_.value(p); });
  if (last_.value && !std::isfinite(*last_.value)) last_.value.reset();
  ++tried_since_best_;
  if (!last_.value) {
    ++report_.failed_evaluations;
    ++failed_since_best_;
    step_limit_ = 0.5 * (p - iterate_).lpNorm<Eigen::Infinity>();
  } else if (!best_.value || *last_.value < *best_.value) {
    best_ = last_;
    tried_since_best_ = failed_since_best_ = 0;
    report_.history.push_back({report_.evaluations, seconds(), *last_.value});
  }
}

bool Evaluator::may_evaluate(const Eigen::VectorXd& p) {
  if (finished()) return false;
  if (options_.stop.stop_requested())
    reason_ = Reason::stopped;
  else if (report_.evaluations >= options_.max_evaluations)
    reason_ = Reason::evaluation_limit;
  else if (failed_since_best_ >= max_failures_in_vain)
    reason_ = Reason::lost;
  return !finished() && (p - iterate_).lpNorm<Eigen::Infinity>() <= step_limit_ * (1.0 + 1e-12);
}

std::optional<double> Evaluator::value(const Point& p) {
  if (!p.allFinite()) return std::nullopt;
  const Eigen::VectorXd inside = between_bounds(problem_, p);
  if (last_.p.size() > 0 && inside == last_.p) return last_.value;
  if (!may_evaluate(inside)) return std::nullopt;
  evaluate(inside);
  return last_.value;
}

bool Evaluator::evaluate_gradient() {
  if (last_.gradient) return true;
  Eigen::VectorXd g;
  bool known = false;
  ++report_.gradients;
  guarded([&] {
    known = problem_.gradient(last_.p, g);
    core::require(!known || g.size() == problem_.size(), "Problem::gradient: wrong size");
  });
  if (!known || exception_ != nullptr || !g.allFinite()) return false;
  last_.gradient = g;
  if (last_.p == best_.p) best_.gradient = g;
  return true;
}

bool Evaluator::gradient(const Point& p, Eigen::VectorXd& g) {
  if (!value(p) || exception_ != nullptr || !evaluate_gradient()) return false;
  g = *last_.gradient;
  return true;
}

bool Evaluator::hessian(const Point& p, Eigen::MatrixXd& h) {
  if (!value(p) || finished()) return false;
  bool known = false;
  ++report_.hessians;
  guarded([&] {
    known = problem_.hessian(last_.p, h);
    core::require(!known || (h.rows() == problem_.size() && h.cols() == problem_.size()),
                  "Problem::hessian: wrong size");
  });
  return known && exception_ == nullptr && h.allFinite();
}

double Evaluator::slope(const Evaluation& at) const {
  return projected_gradient(problem_, at.p, *at.gradient).lpNorm<Eigen::Infinity>();
}

bool Evaluator::is_level() const {
  if (accepted_values_.size() < level_window) return false;
  const auto [low, high] =
      std::minmax_element(accepted_values_.end() - level_window, accepted_values_.end());
  return *high - *low <= options_.value_tolerance * std::max(1.0, std::abs(*low));
}

void Evaluator::accept(const Point& p) {
  const Eigen::VectorXd inside = between_bounds(problem_, p);
  if (finished() || inside == iterate_ || inside != last_.p || !last_.gradient) return;
  iterate_ = inside;
  step_limit_ *= 2.0;
  ++report_.iterations;
  accepted_values_.push_back(*last_.value);
  const double steepest = slope(last_);
  const double tolerance = options_.gradient_tolerance * std::max(1.0, std::abs(*last_.value));
  if (options_.progress)
    guarded([&] {
      options_.progress({.iteration = report_.iterations,
                         .evaluations = report_.evaluations,
                         .seconds = seconds(),
                         .value = *last_.value,
                         .projected_gradient = steepest,
                         .point = iterate_});
    });
  if (steepest <= tolerance) {
    reason_ = Reason::converged;
    // A trial on the way may lie lower by less than matters and not be flat.
    if (*last_.value <= *best_.value + tolerance) best_ = last_;
  } else if (report_.iterations >= options_.max_iterations) {
    reason_ = Reason::iteration_limit;
  } else if (is_level()) {
    reason_ = Reason::small_progress;
  }
}

void Evaluator::describe(const std::string& breakdown) {
  if (!report_.usable) {
    report_.message = report_.reason == Reason::stopped
                          ? "stopped on request before the start was evaluated"
                          : "the start cannot be evaluated";
    return;
  }
  report_.message = phrase(report_.reason);
  if (report_.reason == Reason::failed) report_.message += " (" + breakdown + ")";
  std::array<char, 128> numbers{};
  std::snprintf(numbers.data(), numbers.size(),
                ": value %.6g, projected gradient %.2g after %d evaluations", report_.value,
                report_.projected_gradient, report_.evaluations);
  report_.message += numbers.data();
  if (report_.failed_evaluations > 0)
    report_.message += ", " + std::to_string(report_.failed_evaluations) + " of which failed";
}

Report Evaluator::finish(const std::string& breakdown) {
  // A method may have gone on to other points since its best one.
  if (exception_ == nullptr && best_.value && !best_.gradient) {
    if (last_.p != best_.p) evaluate(best_.p);
    if (exception_ == nullptr && last_.value && last_.p == best_.p) evaluate_gradient();
  }
  if (exception_ != nullptr) std::rethrow_exception(exception_);

  report_.usable = best_.value.has_value();
  report_.point = best_.p;
  if (best_.value) report_.value = *best_.value;
  if (best_.gradient) report_.projected_gradient = slope(best_);
  const bool is_flat = report_.projected_gradient <=
                       options_.gradient_tolerance * std::max(1.0, std::abs(report_.value));
  if (report_.usable && is_flat)
    report_.reason = Reason::converged;
  else if (reason_ && *reason_ != Reason::converged)
    report_.reason = *reason_;
  else if (!breakdown.empty())
    report_.reason = Reason::failed;
  else
    report_.reason =
        2 * failed_since_best_ > tried_since_best_ ? Reason::lost : Reason::small_progress;
  report_.seconds = seconds();
  describe(breakdown);
  return std::move(report_);
}

}  // namespace tencer::optimize
