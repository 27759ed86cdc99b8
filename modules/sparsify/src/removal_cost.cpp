#include "removal_cost.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "design_variables.hpp"

namespace tencer::sparsify {
namespace {

constexpr double largest_step = 0.5;  // of a variable

// The damped Gauss-Newton step of the variables, and the distance that remains, both with the
// variable `fixed` held.
struct Refit {
  Eigen::VectorXd step;
  double distance = 0.0;
};

Refit refit(Eigen::MatrixXd jacobian, const Eigen::VectorXd& residual, Eigen::Index fixed) {
  // A step of one (a stiffness gone, an attachment moved by an edge) costs a hundredth of the
  // distance that is accepted: steps beyond the reach of the linear model do not pay.
  constexpr double damping = 1e-2;
  jacobian.col(fixed).setZero();
  Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
  normal.diagonal().array() += damping;
  const Eigen::VectorXd slope = jacobian.transpose() * residual;
  Refit result{.step = -normal.ldlt().solve(slope)};
  result.distance = residual.squaredNorm() + slope.dot(result.step);
  return result;
}

}  // namespace

std::vector<Removal> removals(const Network& network, const sensitivity::Target& target,
                              const RefineSetup& setup, const Control& control, Effort& effort) {
  const auto& cables = network.structure.cables;
  const auto variables = design_variables(network, setup, 0.0);
  const auto size = static_cast<Eigen::Index>(variables.size());
  std::vector<sensitivity::Parameter> parameters;
  for (const auto& variable : variables) parameters.push_back(variable.parameter);
  const Eigen::VectorXd now = sensitivity::values(cables, parameters);
  // Stiffnesses count by their roots, as in the optimization.
  Eigen::VectorXd rates(size);
  for (Eigen::Index i = 0; i < size; ++i)
    rates[i] = is_stiffness(variables[i]) ? 2 * std::sqrt(now[i]) * variables[i].scale
                                          : variables[i].scale;
  const auto stepped = [&](const Eigen::VectorXd& step) {
    Eigen::VectorXd values(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      const Variable& variable = variables[i];
      const bool root = is_stiffness(variable);
      const double p = (root ? std::sqrt(now[i]) : now[i]) / variable.scale +
                       std::clamp(step[i], -largest_step, largest_step);
      const double value = std::clamp(p, variable.lower, variable.upper) * variable.scale;
      values[i] = root ? value * value : value;
    }
    return sensitivity::with_values(cables, parameters, values);
  };

  std::vector<Removal> result;
  sensitivity::Tracker tracker(network.structure, network.state, follow_options(control));
  if (!tracker.first().usable() || !tracker.committed().linearisation.regular) return result;
  const double root_unit = std::sqrt(distance_scale(target, setup.percent));
  for (int i = 0; i < static_cast<int>(cables.size()) && !control.stop.stop_requested(); ++i) {
    auto changed = cables;
    changed[i].stiffness = 0;
    const auto trial = tracker.evaluate(changed);
    effort.solves += trial.solves;
    effort.iterations += trial.equilibrium.iterations;
    const auto& at = tracker.trial();
    if (!trial.usable() || !at.linearisation.regular) continue;
    const auto fit = sensitivity::least_squares(
        sensitivity::Distance(target, at.system, at.state),
        sensitivity::state_derivatives(at, parameters));
    const Refit best =
        refit(fit.jacobian * rates.asDiagonal() / root_unit, fit.residual / root_unit, i);
    changed = stepped(best.step);
    changed[i].stiffness = 0;
    result.push_back({.cable = i, .cost = best.distance, .refitted = std::move(changed)});
  }
  std::ranges::stable_sort(result, {}, &Removal::cost);
  return result;
}

}  // namespace tencer::sparsify
