// The distance from a target as a function of the cables: gradients and Hessians by adjoints
// against differences of equilibria solved again.
#include <tencer/sensitivity/derivatives.hpp>

#include "generators.hpp"

using namespace tencer;
using namespace tencer::property;
using namespace tencer::sensitivity;
using springs::ParameterKind;

namespace {

constexpr double step = 1e-3;

// Stiffnesses, rest lengths and places; these only within an edge, for at a vertex T is not smooth.
std::vector<springs::Parameter> smooth_parameters(const equilibrium::System& system) {
  std::vector<springs::Parameter> result;
  const auto& cables = system.structure().cables;
  const auto within = [&](const springs::End& end) {
    const auto& on_rod = std::get<springs::OnRod>(end);
    const geometry::ArcLength& rod = system.arc_lengths()[on_rod.rod];
    const auto at = rod.locate(on_rod.s);
    const double gone = at.t * rod.edge_length(at.edge);
    return gone > 4 * step && gone < rod.edge_length(at.edge) - 4 * step;
  };
  for (int c = 0; c < static_cast<int>(cables.size()); ++c) {
    result.push_back({ParameterKind::stiffness, c});
    if (within(cables[c].a)) result.push_back({ParameterKind::position_a, c});
    if (within(cables[c].b)) result.push_back({ParameterKind::position_b, c});
  }
  return result;
}

}  // namespace

TEST_CASE("how the distance from a target depends on the cables") {
  rc::prop("gradient, Hessian and its products match differences along a random direction", [] {
    const Held start = held();
    Posed a = start.posed;
    model::Target target = model::make_target(a.structure, a.x);
    for (auto& points : target.points) points += vectors(points.cols(), 0.3);
    Tracker tracker(a.structure, a.state());
    RC_ASSERT(tracker.first().usable());
    const Configuration& at = tracker.committed();
    const auto parameters = smooth_parameters(at.system);
    const Eigen::VectorXd p = values(at.cables(), parameters);
    Eigen::VectorXd direction = numbers(p.size(), -1, 1);
    for (Eigen::Index j = 0; j < p.size(); ++j)
      if (parameters[j].kind == ParameterKind::stiffness) direction[j] *= p[j];

    const Distance distance(target, at.system, at.state);
    const Eigen::VectorXd y = adjoint(at, distance);
    const Eigen::VectorXd slope = gradient(at, parameters, y);
    const Eigen::MatrixXd motions = state_derivatives(at, parameters);
    const Eigen::MatrixXd second = hessian(at, parameters, distance, y, motions);
    const Eigen::VectorXd product = hessian_times(at, parameters, distance, y, direction);
    RC_ASSERT(largest(second - second.transpose()) <= 1e-8 * largest(second));
    RC_ASSERT(largest(product - second * direction) <= 1e-7 * (largest(second * direction) + 1e-6));
    RC_ASSERT(largest(least_squares(distance, motions).gradient() - slope) <=
              1e-8 * largest(slope));

    const auto there = [&](double t) -> const Configuration& {
      const Trial trial = tracker.evaluate(with_values(at.cables(), parameters, p + t * direction));
      RC_PRE(trial.usable());
      return tracker.trial();
    };
    const auto value = [&](double t) { return deviation(target, there(t).state).value; };
    const auto rate = [&](double t) {
      const Configuration& moved = there(t);
      const Distance d(target, moved.system, moved.state);
      return gradient(moved, parameters, adjoint(moved, d)).dot(direction);
    };
    const auto difference = [](const auto& f) {
      return (8 * (f(step) - f(-step)) - (f(2 * step) - f(-2 * step))) / (12 * step);
    };
    // Relative to what may cancel in them.
    RC_ASSERT(std::abs(difference(value) - slope.dot(direction)) <=
              1e-5 * slope.cwiseAbs().dot(direction.cwiseAbs()));
    RC_ASSERT(std::abs(difference(rate) - direction.dot(product)) <=
              1e-4 * direction.cwiseAbs().dot(second.cwiseAbs() * direction.cwiseAbs()));
  });
}
