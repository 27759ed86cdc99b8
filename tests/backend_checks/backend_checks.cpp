#include "backend_checks.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <vector>

namespace tencer::optimize::test {

namespace {

bool is_between_bounds(const Problem& problem, const Eigen::VectorXd& p) {
  return (p.array() >= problem.lower.array()).all() && (p.array() <= problem.upper.array()).all();
}

}  // namespace

void check_report(const Problem& problem, const Report& report) {
  CHECK(is_between_bounds(problem, report.point));
  CHECK(report.usable);
  CHECK(report.value == *problem.value(report.point));
  Eigen::VectorXd g;
  problem.gradient(report.point, g);
  CHECK(report.projected_gradient ==
        projected_gradient(problem, report.point, g).lpNorm<Eigen::Infinity>());
  REQUIRE_FALSE(report.history.empty());
  CHECK(report.history.front().evaluation == 1);
  for (std::size_t i = 1; i < report.history.size(); ++i) {
    CHECK(report.history[i].value < report.history[i - 1].value);
    CHECK(report.history[i].evaluation > report.history[i - 1].evaluation);
    CHECK(report.history[i].seconds >= report.history[i - 1].seconds);
  }
  CHECK(report.history.back().evaluation <= report.evaluations);
  CHECK_FALSE(report.message.empty());
}

void check_answer(const Backend& backend, const Known& known, const Options& options) {
  const Report report = backend.minimise(known.problem, known.start, options);
  INFO(report.message);
  check_report(known.problem, report);
  CHECK(report.reason == Reason::converged);
  CHECK((report.point - known.answer).lpNorm<Eigen::Infinity>() < 1e-5);
  CHECK(report.failed_evaluations == 0);
}

void check_known_answers(const Backend& backend, Curvature curvature) {
  const Options options{.gradient_tolerance = 1e-7, .value_tolerance = 0.0, .curvature = curvature};
  check_answer(backend, quadratic_with_active_bounds(), options);
  check_answer(backend, rosenbrock_cut_off(), options);
  check_answer(backend, convex_quartic(), options);
}

void check_lost_places(const Backend& backend) {
  const Options options{.gradient_tolerance = 1e-7};
  const Eigen::Vector2d inside(0.4, 0.4), beyond(1.0, 1.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();

  const Known reachable = with_an_edge(inside, std::nullopt);
  const Report found = backend.minimise(reachable.problem, reachable.start, options);
  INFO(found.message);
  check_report(reachable.problem, found);
  CHECK(found.reason == Reason::converged);
  CHECK((found.point - inside).norm() < 1e-5);

  const Known unreachable = with_an_edge(beyond, std::nullopt);
  const Report ended = backend.minimise(unreachable.problem, unreachable.start, options);
  INFO(ended.message);
  check_report(unreachable.problem, ended);
  CHECK(ended.reason != Reason::converged);
  CHECK(ended.failed_evaluations > 0);
  CHECK(ended.point.sum() < 1.0);
  CHECK(ended.value < 0.25 * ended.history.front().value);
  CHECK(ended.evaluations < options.max_evaluations);

  const Known not_a_number = with_an_edge(beyond, nan);
  const Report same = backend.minimise(not_a_number.problem, not_a_number.start, options);
  CHECK(same.point == ended.point);
  CHECK(same.failed_evaluations == ended.failed_evaluations);

  const Report nowhere = backend.minimise(reachable.problem, Eigen::Vector2d(3.0, 3.0), options);
  CHECK(nowhere.reason == Reason::lost);
  CHECK_FALSE(nowhere.usable);
  CHECK(nowhere.point == Eigen::Vector2d(3.0, 3.0));
  CHECK(nowhere.evaluations == 1);
}

void check_exceptions(const Backend& backend) {
  const Known known = rosenbrock_cut_off();
  for (const int at : {1, 2, 7}) {
    CAPTURE(at);
    int calls = 0;
    Problem problem = known.problem;
    problem.value = [&](const Eigen::VectorXd& p) {
      if (++calls == at) throw Mishap("value");
      return known.problem.value(p);
    };
    CHECK_THROWS_AS(backend.minimise(problem, known.start, {}), Mishap);
    CHECK(calls == at);  // nothing is evaluated after it

    calls = 0;
    problem = known.problem;
    problem.gradient = [&](const Eigen::VectorXd& p, Eigen::VectorXd& g) {
      if (++calls == at) throw Mishap("gradient");
      return known.problem.gradient(p, g);
    };
    CHECK_THROWS_AS(backend.minimise(problem, known.start, {}), Mishap);
    CHECK(calls == at);
  }
  const Options options{.progress = [](const Progress&) { throw Mishap("progress"); }};
  CHECK_THROWS_AS(backend.minimise(known.problem, known.start, options), Mishap);
}

void check_limits(const Backend& backend) {
  const Known known = rosenbrock_cut_off();
  for (const int limit : {1, 2, 5, 9}) {
    CAPTURE(limit);
    int calls = 0;
    Problem problem = known.problem;
    problem.value = [&](const Eigen::VectorXd& p) {
      ++calls;
      return known.problem.value(p);
    };
    const Report report = backend.minimise(problem, known.start, {.max_evaluations = limit});
    CHECK(report.evaluations == calls);
    CHECK(calls >= limit);
    CHECK(calls <= limit + 1);
    check_report(known.problem, report);
    CHECK(report.reason == Reason::evaluation_limit);
  }
  for (const int limit : {1, 4}) {
    const Report report = backend.minimise(known.problem, known.start, {.max_iterations = limit});
    CHECK(report.reason == Reason::iteration_limit);
    CHECK(report.iterations == limit);
    check_report(known.problem, report);
  }
}

void check_stop(const Backend& backend) {
  const Known known = rosenbrock_cut_off();
  std::stop_source source;
  int seen = 0, evaluations = 0;
  Options options{.stop = source.get_token()};
  options.progress = [&](const Progress& progress) {
    CHECK(progress.iteration == ++seen);
    evaluations = progress.evaluations;
    CHECK(is_between_bounds(known.problem, progress.point));
    if (seen == 3) source.request_stop();
  };
  const Report report = backend.minimise(known.problem, known.start, options);
  CHECK(seen == 3);
  CHECK(report.reason == Reason::stopped);
  CHECK(report.evaluations <= evaluations + 1);
  check_report(known.problem, report);

  const Report at_once = backend.minimise(known.problem, known.start, options);
  CHECK(at_once.reason == Reason::stopped);
  CHECK(at_once.evaluations == 0);
  CHECK_FALSE(at_once.usable);
}

void check_callers_mistakes(const Backend& backend) {
  const Known known = rosenbrock_cut_off();
  const Eigen::VectorXd wrong_size = Eigen::VectorXd::Zero(3);
  CHECK_THROWS_AS(backend.minimise(known.problem, wrong_size, {}), std::invalid_argument);
  CHECK_THROWS_AS(backend.minimise(known.problem, known.start, {.max_evaluations = 0}),
                  std::invalid_argument);
  Problem no_hessian = known.problem;
  no_hessian.hessian = nullptr;
  CHECK_THROWS_AS(backend.minimise(no_hessian, known.start, {.curvature = Curvature::supplied}),
                  std::invalid_argument);
}

namespace {

void check_starts(const Backend& backend) {
  const Options options{.gradient_tolerance = 1e-7, .value_tolerance = 0.0};
  Known known = quadratic_with_active_bounds();
  known.start = Eigen::VectorXd::LinSpaced(12, -3.0, 4.0);  // beyond the bounds
  check_answer(backend, known, options);
  known.start.setZero();  // in the corner
  check_answer(backend, known, options);

  known.start = known.answer;
  const Report report = backend.minimise(known.problem, known.start, options);
  CHECK(report.reason == Reason::converged);
  CHECK(report.evaluations == 1);
}

void check_fixed_parameters(const Backend& backend) {
  const Options options{.gradient_tolerance = 1e-7, .value_tolerance = 0.0};
  Known known = quadratic_with_active_bounds();
  // Held at their answers, they leave the others' unchanged.
  for (const int i : {0, 5, 9}) known.problem.lower[i] = known.problem.upper[i] = known.answer[i];
  check_answer(backend, known, options);
  known.problem.lower = known.problem.upper = known.answer;
  check_answer(backend, known, options);
}

void check_initial_step(const Backend& backend) {
  const Known known = quadratic_with_active_bounds();
  Options options{.gradient_tolerance = 1e-7, .value_tolerance = 0.0, .initial_step = 5e-3};
  check_answer(backend, known, options);

  double limit = options.initial_step;
  Eigen::VectorXd iterate = known.start;
  Problem problem = known.problem;
  problem.value = [&](const Eigen::VectorXd& p) {
    CHECK((p - iterate).lpNorm<Eigen::Infinity>() <= limit * (1.0 + 1e-9));
    return known.problem.value(p);
  };
  options.progress = [&](const Progress& progress) {
    iterate = progress.point;
    limit *= 2.0;
  };
  CHECK(backend.minimise(problem, known.start, options).usable);
}

void check_repeatable(const Backend& backend) {
  const Known known = rosenbrock_cut_off();
  const Report first = backend.minimise(known.problem, known.start, {});
  const Report second = backend.minimise(known.problem, known.start, {});
  CHECK(first.point == second.point);
  CHECK(first.evaluations == second.evaluations);
}

}  // namespace

void check_backend(const Backend& backend) {
  CAPTURE(backend.name);
  CHECK_FALSE(backend.description.empty());
  SECTION(backend.name + ": known answers") {
    check_known_answers(backend, Curvature::limited_memory);
  }
  SECTION(backend.name + ": starts beyond, at and within the bounds") { check_starts(backend); }
  SECTION(backend.name + ": fixed parameters") { check_fixed_parameters(backend); }
  SECTION(backend.name + ": places without a value") { check_lost_places(backend); }
  SECTION(backend.name + ": exceptions of the problem surface") { check_exceptions(backend); }
  SECTION(backend.name + ": limits") { check_limits(backend); }
  SECTION(backend.name + ": stop token") { check_stop(backend); }
  SECTION(backend.name + ": the initial step") { check_initial_step(backend); }
  SECTION(backend.name + ": same input, same answer") { check_repeatable(backend); }
  SECTION(backend.name + ": caller's mistakes") { check_callers_mistakes(backend); }
}

}  // namespace tencer::optimize::test
