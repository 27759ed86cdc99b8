#include "rounds.hpp"

#include <algorithm>
#include <cmath>
#include <tencer/network/rest_length.hpp>
#include <utility>

#include "homotopy.hpp"
#include "variables.hpp"

namespace tencer::sparsify {
namespace {

using network::Network;

// T of a shape that is `percent` of the target's diagonal away, rms.
double distance_scale(const model::Target& target, double percent) {
  double weights = 0;
  for (std::size_t rod = 0; rod < target.points.size(); ++rod)
    weights += model::weights_of(target, rod).sum();
  return weights * std::pow(percent / 100 * model::diagonal(target), 2);
}

class Objective {
 public:
  Objective(const model::Target& target, const RoundsSetup& setup)
      : target_(target),
        setup_(setup),
        distance_scale_(distance_scale(target, setup.unit_percent)) {}

  double operator()(const Network& network) const {
    double value = sensitivity::deviation(target_, network.state).value / distance_scale_;
    const Eigen::VectorXd q = force_densities(network);
    for (Eigen::Index i = 0; i < q.size(); ++i)
      value += weight_of(network.structure.cables[i], setup_) *
               std::sqrt(std::max(q[i], 0.0) / setup_.reference);
    return value;
  }

 private:
  const model::Target& target_;
  const RoundsSetup& setup_;
  double distance_scale_;
};

// Takes out the cables whose force density has vanished: those below a small part of the reference
// if that hardly changes the objective, and in any case those that do not pull.
std::optional<Network> without_vanished(const Network& network, const RoundsSetup& setup,
                                        const Objective& objective, const network::Control& control,
                                        network::SolveCounts& counts) {
  const double value = objective(network);
  const Eigen::VectorXd q = force_densities(network);
  for (const double share : {3e-2, 1e-3}) {
    std::vector<int> vanished;
    for (Eigen::Index i = 0; i < q.size(); ++i)
      if (weight_of(network.structure.cables[i], setup) > 0 &&
          q[i] < share * share * setup.reference)
        vanished.push_back(static_cast<int>(i));
    if (vanished.empty()) break;
    auto left = without(network, vanished, control, counts);
    if (left) left = pulling_only(std::move(*left), control, counts);
    if (left && objective(*left) <= 1.01 * value) return left;
  }
  return pulling_only(network, control, counts);
}

}  // namespace

double weight_of(const springs::Cable& cable, const RoundsSetup& setup) {
  return model::is_external(cable) ? setup.external : setup.internal;
}

double min_eigenvalue(const Network& network, const OuterOptions& outer) {
  return std::min(outer.min_eigenvalue, 0.5 * stiffest_eigenvalue(network));
}

Improved improve_in_rounds(const Network& network, const model::Target& target,
                           const RoundsSetup& setup, const optimize::Backend& backend,
                           const OuterOptions& outer, const network::Control& control,
                           network::SolveCounts& counts) {
  const Objective objective(target, setup);
  Improved best{.network = network};
  double value = objective(best.network);
  const bool supplied =
      backend.uses_hessian && outer.second_derivatives != model::SecondDerivatives::limited_memory;
  const int iterations = supplied ? outer.iterations : outer.iterations_without;
  for (int round = 0; round < outer.rounds && !control.stop.stop_requested(); ++round) {
    const auto rest = smallest_stable_rest_length(
        best.network,
        {.margin = outer.stability_margin, .min_eigenvalue = 2 * setup.min_eigenvalue});
    if (!rest.stable) {
      best.note = "unstable at every rest length";
      break;
    }
    const Network from = rebased(best.network, rest.rest_ratio);
    DesignProblem design(
        from, target,
        {.variables = design_variables(from, setup, rest.rest_ratio),
         .distance_scale = distance_scale(target, setup.unit_percent),
         // A cable that is too long already must not keep the others from improving.
         .max_cable_length = std::max(setup.rules.max_cable_length, cable_lengths(from).maxCoeff()),
         .min_eigenvalue = std::min(setup.min_eigenvalue, 0.5 * rest.smallest_eigenvalue),
         .all_pull = setup.external == 0 && setup.internal == 0,
         .exact = outer.second_derivatives == model::SecondDerivatives::exact},
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
    counts += design.counts();
    if (found) found = without_vanished(*found, setup, objective, control, counts);
    const double reached = found ? objective(*found) : value;
    if (!(reached < value)) break;
    const double gain = value - reached;
    best.network = std::move(*found);
    value = reached;
    if (gain < outer.min_gain * (value + gain)) break;
  }
  best.deviation = sensitivity::deviation(target, best.network.state);
  return best;
}

}  // namespace tencer::sparsify
