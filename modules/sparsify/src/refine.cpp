#include "refine.hpp"

#include <algorithm>
#include <cmath>
#include <tencer/geometry/measure.hpp>
#include <tencer/sparsify/rest_length.hpp>
#include <utility>

#include "design_variables.hpp"

namespace tencer::sparsify {
namespace {

class Objective {
 public:
  Objective(const sensitivity::Target& target, const RefineSetup& setup)
      : target_(target), setup_(setup), distance_scale_(distance_scale(target, setup.percent)) {}

  double operator()(const Network& network) const {
    double value = sensitivity::deviation(target_, network.state).value / distance_scale_;
    const Eigen::VectorXd q = force_densities(network);
    for (Eigen::Index i = 0; i < q.size(); ++i)
      value += weight_of(network.structure.cables[i], setup_) *
               std::sqrt(std::max(q[i], 0.0) / setup_.reference);
    return value;
  }

 private:
  const sensitivity::Target& target_;
  const RefineSetup& setup_;
  double distance_scale_;
};

// Takes out the cables whose force density has vanished: those below a small part of the reference
// if that hardly changes the objective, and in any case those that do not pull.
std::optional<Network> without_vanished(const Network& network, const RefineSetup& setup,
                                        const Objective& objective, const Control& control,
                                        Effort& effort) {
  const double value = objective(network);
  const Eigen::VectorXd q = force_densities(network);
  for (const double share : {3e-2, 1e-3}) {
    std::vector<int> vanished;
    for (Eigen::Index i = 0; i < q.size(); ++i)
      if (weight_of(network.structure.cables[i], setup) > 0 &&
          q[i] < share * share * setup.reference)
        vanished.push_back(static_cast<int>(i));
    if (vanished.empty()) break;
    auto left = without(network, vanished, control, effort);
    if (left) left = pulling_only(std::move(*left), control, effort);
    if (left && objective(*left) <= 1.01 * value) return left;
  }
  return pulling_only(network, control, effort);
}

}  // namespace

double distance_scale(const sensitivity::Target& target, double percent) {
  std::vector<geometry::Polyline> curves;
  double weights = 0;
  for (std::size_t rod = 0; rod < target.points.size(); ++rod) {
    curves.push_back({.points = target.points[rod]});
    weights += target.weights.empty() ? static_cast<double>(target.points[rod].cols())
                                      : target.weights[rod].sum();
  }
  return weights * std::pow(percent / 100 * geometry::bounding_box_diagonal(curves), 2);
}

double least_eigenvalue(const Network& network, const OuterOptions& outer) {
  return std::min(outer.least_eigenvalue, 0.5 * stiffest_eigenvalue(network));
}

Eigen::VectorXd force_densities(const Network& network) {
  return cable_tensions(network).cwiseQuotient(cable_lengths(network));
}

Refined refine(const Network& network, const sensitivity::Target& target, const RefineSetup& setup,
               const optimize::Backend& backend, const OuterOptions& outer, const Control& control,
               Effort& effort) {
  const Objective objective(target, setup);
  Refined best{.network = network};
  double value = objective(best.network);
  const bool supplied = backend.uses_hessian && outer.second_derivatives != SecondDerivatives::none;
  const int iterations = supplied ? outer.iterations : outer.iterations_without;
  for (int round = 0; round < outer.rounds && !control.stop.stop_requested(); ++round) {
    const auto rest = smallest_stable_rest_length(
        best.network, {.margin = outer.stability_margin, .least = 2 * setup.least_eigenvalue});
    if (!rest.stable) {
      best.note = "unstable at every rest length";
      break;
    }
    const Network from = rebased(best.network, rest.rho);
    DesignProblem design(
        from, target,
        {.variables = design_variables(from, setup, rest.rho),
         .distance_scale = distance_scale(target, setup.percent),
         // A cable that is too long already must not keep the others from improving.
         .longest = std::max(setup.rules.longest, cable_lengths(from).maxCoeff()),
         .least_eigenvalue = std::min(setup.least_eigenvalue, 0.5 * rest.smallest_eigenvalue),
         .all_pull = setup.external == 0 && setup.internal == 0,
         .exact = outer.second_derivatives == SecondDerivatives::exact},
        control);
    if (!design.usable()) {
      best.note = "the equilibrium was lost when rest lengths were set";
      break;
    }
    const auto report = backend.minimise(
        design.problem(), design.start(),
        {.max_evaluations = 3 * iterations,
         .max_iterations = iterations,
         .gradient_tolerance = outer.gradient_tolerance,
         .value_tolerance = outer.value_tolerance,
         .initial_step = 0.5,
         .curvature =
             supplied ? optimize::Curvature::supplied : optimize::Curvature::limited_memory,
         .stop = control.stop,
         .progress = [&](const optimize::Progress& progress) { design.move_to(progress.point); }});
    std::optional<Network> found = design.best();
    effort.solves += design.solves();
    effort.iterations += design.iterations();
    if (found) found = without_vanished(*found, setup, objective, control, effort);
    const double reached = found ? objective(*found) : value;
    if (!(reached < value)) break;
    const double gain = value - reached;
    best.network = std::move(*found);
    value = reached;
    if (gain < outer.least_gain * (value + gain)) break;
  }
  best.deviation = sensitivity::deviation(target, best.network.state);
  return best;
}

}  // namespace tencer::sparsify
