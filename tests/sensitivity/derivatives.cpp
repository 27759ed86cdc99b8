#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "fixtures.hpp"

namespace tencer::sensitivity {
namespace {

double relative(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).norm() / b.norm();
}

struct Derivatives {
  std::vector<springs::Parameter> parameters;
  Eigen::VectorXd p, adjoint, gradient;
  Eigen::MatrixXd motions, hessian;
  LeastSquares squares;

  Derivatives(const model::Target& target, const Configuration& at)
      : parameters(all_parameters(at.system.structure())), p(values(at.cables(), parameters)) {
    const Distance d = distance(target, at);
    adjoint = sensitivity::adjoint(at, d);
    gradient = sensitivity::gradient(at, parameters, adjoint);
    motions = state_derivatives(at, parameters);
    squares = least_squares(d, motions);
    hessian = sensitivity::hessian(at, parameters, d, adjoint, motions);
  }
};

// The configuration of the equilibrium with other values of all parameters, from scratch.
const Configuration& solved(Tracker& tracker, const Derivatives& at, const Eigen::VectorXd& p) {
  const Trial trial = tracker.evaluate(with_values(tracker.committed().cables(), at.parameters, p));
  REQUIRE(trial.usable());
  return tracker.trial();
}

}  // namespace

TEST_CASE("gradients agree with differences of equilibria solved again") {
  for (const Example& e : examples()) {
    INFO(e.name);
    Tracker tracker = track(e);
    REQUIRE(tracker.first().usable());
    const Derivatives at(e.target, tracker.committed());
    constexpr double h = 1e-4;
    Eigen::VectorXd differences(at.p.size());
    for (Eigen::Index j = 0; j < at.p.size(); ++j) {
      const auto value = [&](double step) {
        return deviation(
                   e.target,
                   solved(tracker, at, at.p + step * Eigen::VectorXd::Unit(at.p.size(), j)).state)
            .value;
      };
      // Fourth order, so that truncation stays below rounding.
      differences[j] = (8 * (value(h) - value(-h)) - (value(2 * h) - value(-2 * h))) / (12 * h);
    }
    CHECK(relative(at.gradient, differences) < 1e-8);
    CHECK(relative(at.squares.gradient(), at.gradient) < 1e-9);
  }
}

TEST_CASE("Gauss-Newton's residual rates agree with differences") {
  for (const Example& e : examples()) {
    INFO(e.name);
    Tracker tracker = track(e);
    // At a target that the structure attains the residual's rates are those of the residual itself.
    model::Target target = e.target;
    for (std::size_t r = 0; r < target.points.size(); ++r)
      target.points[r] = tracker.committed().state[r].x;
    const Derivatives at(target, tracker.committed());
    constexpr double h = 1e-4;
    Eigen::MatrixXd differences(at.squares.jacobian.rows(), at.p.size());
    for (Eigen::Index j = 0; j < at.p.size(); ++j) {
      const auto residual = [&](double step) {
        return distance(target,
                        solved(tracker, at, at.p + step * Eigen::VectorXd::Unit(at.p.size(), j)))
            .residual();
      };
      differences.col(j) =
          (8 * (residual(h) - residual(-h)) - (residual(2 * h) - residual(-2 * h))) / (12 * h);
    }
    CHECK(relative(at.squares.jacobian, differences) < 1e-7);
    CHECK(relative(at.squares.gauss_newton(), at.hessian) < 1e-7);
  }
}

TEST_CASE("exact Hessians agree with differences of gradients") {
  for (const Example& e : examples()) {
    INFO(e.name);
    Tracker tracker = track(e);
    const Derivatives at(e.target, tracker.committed());
    constexpr double h = 1e-4;
    Eigen::MatrixXd differences(at.p.size(), at.p.size());
    for (Eigen::Index j = 0; j < at.p.size(); ++j) {
      const auto slope = [&](double step) -> Eigen::VectorXd {
        const Configuration& moved =
            solved(tracker, at, at.p + step * Eigen::VectorXd::Unit(at.p.size(), j));
        return gradient(moved, at.parameters, adjoint(moved, distance(e.target, moved)));
      };
      differences.col(j) = (8 * (slope(h) - slope(-h)) - (slope(2 * h) - slope(-2 * h))) / (12 * h);
    }
    CHECK(relative(at.hessian, differences) < 1e-7);
    CHECK(relative(at.squares.gauss_newton(), differences) > 1e-3);
    const Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(at.p.size(), -1, 2);
    const Eigen::VectorXd product = hessian_times(
        tracker.committed(), at.parameters, distance(e.target, tracker.committed()), at.adjoint, q);
    CHECK(relative(product, at.hessian * q) < 1e-9);
  }
}

TEST_CASE("moving the target rigidly changes nothing where it is aligned") {
  for (const Example& e : examples()) {
    if (!e.target.align) continue;
    INFO(e.name);
    const Tracker tracker = track(e);
    const Derivatives at(e.target, tracker.committed());
    const Eigen::Vector3d axis =
        e.target.planar ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(0.3, -0.5, 0.8).normalized();
    const registration::RigidMotion motion{
        .rotation = Eigen::AngleAxisd(2.6, axis).toRotationMatrix(),
        .translation = e.target.planar ? Eigen::Vector3d(3, -1, 0) : Eigen::Vector3d(3, -1, 2)};
    model::Target moved = e.target;
    for (auto& points : moved.points) points = motion.apply(points);
    moved.views = turned(moved.views, motion.rotation);
    const Derivatives there(moved, tracker.committed());
    CHECK(deviation(moved, tracker.committed().state).value ==
          Approx(deviation(e.target, tracker.committed().state).value).epsilon(1e-11));
    CHECK(relative(there.gradient, at.gradient) < 1e-10);
    CHECK(relative(there.hessian, at.hessian) < 1e-10);
    CHECK(relative(there.squares.gauss_newton(), at.squares.gauss_newton()) < 1e-10);
  }
}

TEST_CASE("a thin wire's gradient and Hessian hold up") {
  // EA L^2 / EI around 4e8.
  Example e = closed_rod(1e7);
  e.start = {track(closed_rod(1e4)).committed().state[0].x};
  Tracker tracker = track(e);
  REQUIRE(tracker.first().usable());
  const Derivatives at(e.target, tracker.committed());
  const Eigen::VectorXd q = Eigen::VectorXd::LinSpaced(at.p.size(), -1, 1);
  constexpr double h = 1e-3;
  const auto value = [&](double step) {
    return deviation(e.target, solved(tracker, at, at.p + step * q).state).value;
  };
  const auto slope = [&](double step) -> Eigen::VectorXd {
    const Configuration& moved = solved(tracker, at, at.p + step * q);
    return gradient(moved, at.parameters, adjoint(moved, distance(e.target, moved)));
  };
  const double by_value = (8 * (value(h) - value(-h)) - (value(2 * h) - value(-2 * h))) / (12 * h);
  CHECK(at.gradient.dot(q) == Approx(by_value).epsilon(1e-6));
  const Eigen::VectorXd by_slope =
      (8 * (slope(h) - slope(-h)) - (slope(2 * h) - slope(-2 * h))) / (12 * h);
  CHECK(relative(at.hessian * q, by_slope) < 1e-5);
}

}  // namespace tencer::sensitivity
