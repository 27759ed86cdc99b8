#include "removal_cost.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "design_variables.hpp"

namespace tencer::sparsify {
namespace {

// The distance, in units of `unit`, that remains when the variables take a damped Gauss-Newton
// step; the variable `fixed` stays.
double after_refit(const sensitivity::LeastSquares& fit, double unit, Eigen::Index fixed) {
  // A step of one (a stiffness gone, an attachment moved by an edge) is worth a hundredth of the
  // distance that is accepted: steps beyond the reach of the linear model do not pay.
  constexpr double damping = 1e-2;
  Eigen::MatrixXd jacobian = fit.jacobian / std::sqrt(unit);
  jacobian.col(fixed).setZero();
  const Eigen::VectorXd residual = fit.residual / std::sqrt(unit);
  Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
  normal.diagonal().array() += damping;
  const Eigen::VectorXd slope = jacobian.transpose() * residual;
  return residual.squaredNorm() - slope.dot(normal.ldlt().solve(slope));
}

}  // namespace

std::vector<int> by_removal_cost(const Network& network, const sensitivity::Target& target,
                                 const RefineSetup& setup, const Control& control, Effort& effort) {
  const int cables = static_cast<int>(network.structure.cables.size());
  std::vector<int> order(cables);
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> cost(cables, std::numeric_limits<double>::infinity());

  const auto variables = design_variables(network, setup, 0.0);
  std::vector<sensitivity::Parameter> parameters;
  Eigen::VectorXd rates(static_cast<Eigen::Index>(variables.size()));
  for (const auto& variable : variables) {
    rates[static_cast<Eigen::Index>(parameters.size())] =
        variable.parameter.kind == sensitivity::Kind::stiffness
            ? 2 * network.structure.cables[variable.parameter.cable].stiffness
            : variable.scale;
    parameters.push_back(variable.parameter);
  }
  sensitivity::Tracker tracker(network.structure, network.state, follow_options(control));
  if (!tracker.first().usable() || !tracker.committed().linearisation.regular) return order;
  for (int i = 0; i < cables && !control.stop.stop_requested(); ++i) {
    auto without_it = network.structure.cables;
    without_it[i].stiffness = 0;
    const auto trial = tracker.evaluate(std::move(without_it));
    effort.solves += trial.solves;
    effort.iterations += trial.equilibrium.iterations;
    const auto& at = tracker.trial();
    if (!trial.usable() || !at.linearisation.regular) continue;
    const sensitivity::Distance distance(target, at.system, at.state);
    auto fit = sensitivity::least_squares(distance, sensitivity::state_derivatives(at, parameters));
    fit.jacobian = fit.jacobian * rates.asDiagonal();
    cost[i] = after_refit(fit, distance_scale(target, setup.percent), i);
  }
  std::ranges::stable_sort(order, {}, [&](int i) { return cost[i]; });
  return order;
}

}  // namespace tencer::sparsify
