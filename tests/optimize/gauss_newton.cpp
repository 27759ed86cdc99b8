#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <tencer/optimize/gauss_newton.hpp>

#include "backend_checks/backend_checks.hpp"

using namespace tencer::optimize;
using namespace tencer::optimize::test;

namespace {

// sum over t of (a exp(-b t) - y(t))^2 for y of a = 2, b = 0.7, with the Gauss-Newton Hessian.
Known exponential_fit(double least_b) {
  struct Fit {
    Eigen::VectorXd residual;
    Eigen::MatrixXd jacobian;
  };
  const auto fit = [](const Eigen::VectorXd& p) {
    Fit result{Eigen::VectorXd(9), Eigen::MatrixXd(9, 2)};
    for (int i = 0; i < 9; ++i) {
      const double t = 0.5 * i, decay = std::exp(-p[1] * t);
      result.residual[i] = p[0] * decay - 2 * std::exp(-0.7 * t);
      result.jacobian.row(i) << decay, -t * p[0] * decay;
    }
    return result;
  };
  Known known;
  known.problem.lower = Eigen::Vector2d(0, least_b);
  known.problem.upper = Eigen::Vector2d(10, 10);
  known.problem.value = [fit](const Eigen::VectorXd& p) {
    return std::optional(0.5 * fit(p).residual.squaredNorm());
  };
  known.problem.gradient = [fit](const Eigen::VectorXd& p, Eigen::VectorXd& g) {
    const Fit at = fit(p);
    g = at.jacobian.transpose() * at.residual;
    return true;
  };
  known.problem.hessian = [fit](const Eigen::VectorXd& p, Eigen::MatrixXd& h) {
    const Fit at = fit(p);
    h = at.jacobian.transpose() * at.jacobian;
    return true;
  };
  known.start = Eigen::Vector2d(0.5, 3);
  known.answer = Eigen::Vector2d(2, 0.7);
  return known;
}

}  // namespace

TEST_CASE("gauss-newton does what every backend must") {
  CHECK(gauss_newton().name == "gauss-newton");
  CHECK(gauss_newton().uses_hessian);
  check_backend(gauss_newton());
}

TEST_CASE("gauss-newton needs few iterations, whatever Options::curvature says") {
  for (const Known& known :
       {quadratic_with_active_bounds(), rosenbrock_cut_off(), convex_quartic()}) {
    const Report plain = gauss_newton().minimise(known.problem, known.start, {});
    const Report supplied =
        gauss_newton().minimise(known.problem, known.start, {.curvature = Curvature::supplied});
    CHECK(plain.point == supplied.point);
    CHECK(plain.hessians > 0);
    CHECK(plain.iterations <= 25);
  }
}

TEST_CASE("gauss-newton reaches active bounds exactly") {
  const Known known = quadratic_with_active_bounds();
  const Report report =
      gauss_newton().minimise(known.problem, known.start, {.gradient_tolerance = 1e-7});
  for (int i = 0; i < 7; ++i) CHECK(report.point[i] == known.answer[i]);
}

TEST_CASE("gauss-newton fits an exponential, with and without a bound in the way") {
  const Options options{.gradient_tolerance = 1e-10, .value_tolerance = 0};
  check_answer(gauss_newton(), exponential_fit(0), options);
  // With b held at 1 the problem is linear in a.
  Known held = exponential_fit(1);
  double above = 0, below = 0;
  for (int i = 0; i < 9; ++i) {
    above += 2 * std::exp(-1.7 * 0.5 * i);
    below += std::exp(-2 * 0.5 * i);
  }
  held.answer = Eigen::Vector2d(above / below, 1);
  check_answer(gauss_newton(), held, options);
}

TEST_CASE("gauss-newton leaves places where an exact Hessian is indefinite") {
  Known known = rosenbrock_cut_off();
  known.start = Eigen::Vector2d(0, 1);
  Eigen::MatrixXd h;
  known.problem.hessian(known.start, h);
  REQUIRE(h.determinant() < 0);
  check_answer(gauss_newton(), known, {.gradient_tolerance = 1e-7, .value_tolerance = 0.0});
}

TEST_CASE("gauss-newton gets along with nothing on the Hessian's diagonal, or nothing at all") {
  Known known;
  known.problem.lower = Eigen::Vector2d(-1, -1);
  known.problem.upper = Eigen::Vector2d(1, 2);
  known.problem.value = [](const Eigen::VectorXd& p) { return std::optional(p[0] * p[1]); };
  known.problem.gradient = [](const Eigen::VectorXd& p, Eigen::VectorXd& g) {
    g = Eigen::Vector2d(p[1], p[0]);
    return true;
  };
  known.problem.hessian = [](const Eigen::VectorXd&, Eigen::MatrixXd& h) {
    h = Eigen::Matrix2d{{0, 1}, {1, 0}};
    return true;
  };
  known.start = Eigen::Vector2d(0.1, 0.3);
  known.answer = Eigen::Vector2d(-1, 2);
  check_answer(gauss_newton(), known, {});

  known.problem.value = [](const Eigen::VectorXd& p) { return std::optional(p[0] - p[1]); };
  known.problem.gradient = [](const Eigen::VectorXd&, Eigen::VectorXd& g) {
    g = Eigen::Vector2d(1, -1);
    return true;
  };
  known.problem.hessian = [](const Eigen::VectorXd&, Eigen::MatrixXd& h) {
    h = Eigen::Matrix2d::Zero();
    return true;
  };
  check_answer(gauss_newton(), known, {});
}

TEST_CASE("gauss-newton without a Hessian is refused") {
  Known known = rosenbrock_cut_off();
  known.problem.hessian = nullptr;
  CHECK_THROWS_WITH(gauss_newton().minimise(known.problem, known.start, {}),
                    "minimise: gauss-newton needs Problem::hessian");
}

TEST_CASE("a Hessian that throws or fails ends gauss-newton's run with the best point kept") {
  Known known = rosenbrock_cut_off();
  known.problem.hessian = [&](const Eigen::VectorXd&, Eigen::MatrixXd&) -> bool {
    throw Mishap("hessian");
  };
  CHECK_THROWS_AS(gauss_newton().minimise(known.problem, known.start, {}), Mishap);

  int calls = 0;
  const auto exact = rosenbrock_cut_off().problem.hessian;
  known.problem.hessian = [&](const Eigen::VectorXd& p, Eigen::MatrixXd& h) {
    return ++calls < 4 && exact(p, h);
  };
  const Report report = gauss_newton().minimise(known.problem, known.start, {});
  INFO(report.message);
  CHECK(report.reason == Reason::failed);
  CHECK(report.value < report.history.front().value);
  check_report(known.problem, report);
}
