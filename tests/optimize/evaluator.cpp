#include <catch2/catch.hpp>
#include <tencer/optimize/evaluator.hpp>

#include "backend_checks/backend_checks.hpp"

using namespace tencer::optimize;
using namespace tencer::optimize::test;

namespace {

// The plainest method, to hold the evaluator against the checks without any third party: projected
// steepest descent with a line search that shortens by halves.
Report descend(const Problem& problem, const Eigen::VectorXd& start, const Options& options) {
  Evaluator evaluator(problem, start, options);
  Eigen::VectorXd p = evaluator.start(), g;
  double step = 1.0;
  while (!evaluator.finished()) {
    const auto here = evaluator.value(p);
    if (!here || !evaluator.gradient(p, g)) break;
    step *= 4.0;
    Eigen::VectorXd trial;
    do {
      step *= 0.5;
      trial = (p - step * g).cwiseMax(problem.lower).cwiseMin(problem.upper);
      const auto there = evaluator.value(trial);
      if (there && *there < *here - 1e-4 * g.dot(p - trial)) break;
    } while (!evaluator.finished() && step > 1e-20);
    if (step <= 1e-20) break;
    if (evaluator.gradient(trial, g)) evaluator.accept(trial);
    p = trial;
  }
  return evaluator.finish();
}

Backend descent() {
  return {.name = "descent",
          .description = "projected steepest descent",
          .uses_hessian = false,
          .minimise = [](const Problem& problem, const Eigen::VectorXd& start, Options options) {
            options.max_evaluations = std::min(options.max_evaluations, 200000);
            return descend(problem, start, options);
          }};
}

}  // namespace

TEST_CASE("the checks hold for the plainest method on the evaluator") {
  const Backend backend = descent();
  SECTION("known answers") {
    const Options options{.max_evaluations = 200000,
                          .max_iterations = 100000,
                          .gradient_tolerance = 1e-7,
                          .value_tolerance = 0.0};
    check_answer(backend, quadratic_with_active_bounds(), options);
    check_answer(backend, convex_quartic(), options);
  }
  SECTION("places without a value") { check_lost_places(backend); }
  SECTION("exceptions") { check_exceptions(backend); }
  SECTION("limits") { check_limits(backend); }
  SECTION("stop") { check_stop(backend); }
  SECTION("caller's mistakes") { check_callers_mistakes(backend); }
}

TEST_CASE("the same point is evaluated once") {
  Known known = quadratic_with_active_bounds();
  const Options options;
  Evaluator evaluator(known.problem, known.start, options);
  Eigen::VectorXd g;
  REQUIRE(evaluator.value(known.start));
  REQUIRE(evaluator.gradient(known.start, g));
  const Report report = evaluator.finish();
  CHECK(report.evaluations == 1);
  CHECK(report.gradients == 1);
}

TEST_CASE("gradients and Hessians are asked for where the value was computed last") {
  Known known = quadratic_with_active_bounds();
  Eigen::VectorXd last;
  Problem problem = known.problem;
  problem.value = [&](const Eigen::VectorXd& p) {
    last = p;
    return known.problem.value(p);
  };
  problem.gradient = [&](const Eigen::VectorXd& p, Eigen::VectorXd& g) {
    CHECK(p == last);
    return known.problem.gradient(p, g);
  };
  problem.hessian = [&](const Eigen::VectorXd& p, Eigen::MatrixXd& h) {
    CHECK(p == last);
    return known.problem.hessian(p, h);
  };
  const Options options{.curvature = Curvature::supplied};
  Evaluator evaluator(problem, known.start, options);
  const Eigen::VectorXd other = Eigen::VectorXd::Constant(12, 0.4);
  REQUIRE(evaluator.value(other));
  Eigen::VectorXd g;
  Eigen::MatrixXd h;
  REQUIRE(evaluator.gradient(known.start, g));
  REQUIRE(evaluator.value(other));
  REQUIRE(evaluator.hessian(known.start, h));
  CHECK(evaluator.finish().hessians == 1);
}

TEST_CASE("points beyond the bounds are moved between them, others than numbers refused") {
  const Known known = rosenbrock_cut_off();
  const Options options;
  Evaluator evaluator(known.problem, Eigen::Vector2d(9.0, 9.0), options);
  CHECK(evaluator.start() == known.problem.upper);
  CHECK(*evaluator.value(Eigen::Vector2d(-9.0, 0.0)) ==
        *known.problem.value(Eigen::Vector2d(-1.5, 0.0)));
  CHECK_FALSE(evaluator.value(Eigen::Vector2d(std::nan(""), 0.0)));
}

TEST_CASE("a run whose values no longer change has made small progress") {
  const Known known = rosenbrock_cut_off();
  const Options options{.gradient_tolerance = 1e-14, .value_tolerance = 1e-3};
  const Report report = descend(known.problem, known.start, options);
  CHECK(report.reason == Reason::small_progress);
  CHECK(report.evaluations < options.max_evaluations);
}

TEST_CASE("a method that breaks down is reported with what it says") {
  const Known known = rosenbrock_cut_off();
  const Options options;
  Evaluator evaluator(known.problem, known.start, options);
  const Report report = evaluator.finish("no memory");
  CHECK(report.reason == Reason::failed);
  CHECK(report.usable);
  CHECK(report.message.find("no memory") != std::string::npos);
}

TEST_CASE("wrong problems and options name what is wrong") {
  Known known = rosenbrock_cut_off();
  Problem problem = known.problem;
  problem.lower[0] = 1.0;
  CHECK_THROWS_WITH(problem.validate(), "Problem: needs lower <= upper");
  problem = known.problem;
  problem.upper[1] = std::nan("");
  CHECK_THROWS_WITH(problem.validate(), "Problem: needs lower <= upper");
  problem = known.problem;
  problem.upper = Eigen::VectorXd::Zero(3);
  CHECK_THROWS_WITH(problem.validate(), "Problem: lower and upper differ in size");
  problem = known.problem;
  problem.gradient = nullptr;
  CHECK_THROWS_WITH(problem.validate(), "Problem: needs value and gradient");
  CHECK_THROWS_WITH(Problem{}.validate(), "Problem: needs at least one parameter");
  CHECK_THROWS_WITH((Options{.gradient_tolerance = 0.0}.validate()),
                    "Options: gradient_tolerance must be positive");
  CHECK_THROWS_WITH((Options{.initial_step = -1.0}.validate()),
                    "Options: initial_step must be positive");
}

TEST_CASE("the projected gradient vanishes exactly where the bounds hold the gradient back") {
  const Known known = quadratic_with_active_bounds();
  Eigen::VectorXd g;
  known.problem.gradient(known.answer, g);
  CHECK(g.lpNorm<Eigen::Infinity>() > 1.0);
  CHECK(projected_gradient(known.problem, known.answer, g).lpNorm<Eigen::Infinity>() < 1e-12);
  known.problem.gradient(known.start, g);
  CHECK(projected_gradient(known.problem, known.start, g).lpNorm<Eigen::Infinity>() > 1e-2);
}

TEST_CASE("a failed trial brings the limit of the step down to half its distance") {
  const Known known = with_an_edge({0.4, 0.4}, std::nullopt);
  const Options options;
  Evaluator evaluator(known.problem, Eigen::Vector2d(0.0, 0.0), options);
  CHECK_FALSE(evaluator.value(Eigen::Vector2d(2.0, 0.0)));
  CHECK_FALSE(evaluator.value(Eigen::Vector2d(-1.5, 0.0)));  // has a value, but is too far
  const Eigen::Vector2d near(-0.9, 0.0);
  CHECK(evaluator.value(near));
  Eigen::VectorXd g;
  REQUIRE(evaluator.gradient(near, g));
  evaluator.accept(near);
  CHECK(evaluator.value(Eigen::Vector2d(-2.8, 0.0)));  // twice as far from there
  const Report report = evaluator.finish();
  CHECK(report.evaluations == 4);
  CHECK(report.failed_evaluations == 1);
}

TEST_CASE("a method that goes on failing is stopped") {
  Known known = with_an_edge({0.4, 0.4}, std::nullopt);
  const auto value = known.problem.value;
  known.problem.value = [&](const Eigen::VectorXd& p) {
    return p.isZero(0.0) ? value(p) : std::nullopt;
  };
  const Options options;
  Evaluator evaluator(known.problem, Eigen::Vector2d(0.0, 0.0), options);
  int trials = 0;
  for (double length = 4.0; !evaluator.finished() && trials < 1000; length *= 0.5, ++trials)
    CHECK_FALSE(evaluator.value(Eigen::Vector2d(length, 0.0)));
  CHECK(trials < 60);
  const Report report = evaluator.finish();
  CHECK(report.reason == Reason::lost);
  CHECK(report.usable);
  CHECK(report.point == Eigen::Vector2d(0.0, 0.0));
  CHECK(report.evaluations == trials);  // the last trial was refused
}
