#include <catch2/catch.hpp>
#include <tencer/optimize_ipopt/backends.hpp>
#include <thread>

#include "backend_checks/backend_checks.hpp"

using namespace tencer;
using namespace tencer::optimize;
using namespace tencer::optimize::test;

namespace {

Backend ipopt() {
  const auto backends = optimize_ipopt::backends();
  REQUIRE(backends.size() == 1);
  return backends.front();
}

}  // namespace

TEST_CASE("ipopt does what every backend must") {
  CHECK(ipopt().name == "ipopt");
  check_backend(ipopt());
}

TEST_CASE("ipopt uses a supplied Hessian") {
  check_known_answers(ipopt(), Curvature::supplied);
  for (const Known& known :
       {quadratic_with_active_bounds(), rosenbrock_cut_off(), convex_quartic()}) {
    const Report estimated = ipopt().minimise(known.problem, known.start, {});
    const Report supplied =
        ipopt().minimise(known.problem, known.start, {.curvature = Curvature::supplied});
    CHECK(estimated.hessians == 0);
    CHECK(supplied.hessians > 0);
    CHECK(supplied.iterations < estimated.iterations);
    CHECK(supplied.iterations <= 25);
  }
}

TEST_CASE("a Hessian that throws or fails ends ipopt's run with the best point kept") {
  Known known = rosenbrock_cut_off();
  const Options options{.curvature = Curvature::supplied};
  int calls = 0;
  known.problem.hessian = [&](const Eigen::VectorXd&, Eigen::MatrixXd&) -> bool {
    throw Mishap("hessian");
  };
  CHECK_THROWS_AS(ipopt().minimise(known.problem, known.start, options), Mishap);

  const auto exact = rosenbrock_cut_off().problem.hessian;
  known.problem.hessian = [&](const Eigen::VectorXd& p, Eigen::MatrixXd& h) {
    return ++calls < 4 && exact(p, h);
  };
  const Report report = ipopt().minimise(known.problem, known.start, options);
  INFO(report.message);
  CHECK(report.reason != Reason::converged);
  CHECK(report.value < report.history.front().value);
  check_report(known.problem, report);
}

TEST_CASE("ipopt runs in several threads take turns") {
  const Known known = quadratic_with_active_bounds();
  const Report alone = ipopt().minimise(known.problem, known.start, {});
  std::vector<Report> reports(4);
  {
    std::vector<std::jthread> threads;
    for (Report& report : reports)
      threads.emplace_back([&] { report = ipopt().minimise(known.problem, known.start, {}); });
  }
  for (const Report& report : reports) CHECK(report.point == alone.point);
}
