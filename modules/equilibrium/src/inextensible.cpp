#include <algorithm>
#include <cmath>
#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/balancing.hpp>
#include <tencer/equilibrium/constrained.hpp>
#include <tencer/equilibrium/inextensible.hpp>
#include <utility>

#include "balanced_stability.hpp"
#include "forces.hpp"
#include "pulling_cables.hpp"

namespace tencer::equilibrium {
namespace {

// With the stiffness that tension gives a cable across itself.
model::Structure as_pulling(const model::Structure& structure, const model::State& state,
                            const Eigen::VectorXd& tensions) {
  model::Structure pulling = structure;
  const Eigen::VectorXd lengths = model::cable_lengths(structure, state);
  for (std::size_t c = 0; c < pulling.cables.size(); ++c) {
    const auto k = static_cast<Eigen::Index>(c);
    pulling.cables[c].stiffness = lengths[k] > 0 ? tensions[k] / lengths[k] : 0;
  }
  return pulling;
}

double stretch_of(const model::Structure& structure, const Eigen::VectorXd& lengths,
                  const Eigen::VectorXd& tensions) {
  double stretch = 0;
  for (Eigen::Index c = 0; c < lengths.size(); ++c) {
    const double excess = lengths[c] / structure.cables[c].rest_length - 1;
    stretch = std::max(stretch, tensions[c] > 0 ? std::abs(excess) : excess);
  }
  return stretch;
}

void add_counts(const Equilibrium& counted, Equilibrium& sum) {
  sum.iterations += counted.iterations;
  sum.factorisations += counted.factorisations;
  sum.evaluations += counted.evaluations;
  sum.escapes += counted.escapes;
}

}  // namespace

InextensibleEquilibrium relax_inextensible(const model::Structure& structure, model::State start,
                                           const SolveOptions& options) {
  for (const auto& cable : structure.cables)
    core::require(cable.rest_length > 0, "relax_inextensible: every cable needs a length");
  const Eigen::VectorXd tensions = balancing_tensions(structure, start);
  return relax_inextensible(structure, std::move(start), tensions, options);
}

InextensibleEquilibrium relax_inextensible(const model::Structure& structure, model::State start,
                                           const Eigen::VectorXd& tensions,
                                           const SolveOptions& options) {
  constexpr int max_rounds = 30;
  constexpr double enough = 1e-10;
  const auto count = static_cast<Eigen::Index>(structure.cables.size());
  core::require(tensions.size() == count && (count == 0 || tensions.minCoeff() >= 0),
                "relax_inextensible: needs one tension >= 0 per cable");
  for (const auto& cable : structure.cables)
    core::require(cable.rest_length > 0, "relax_inextensible: every cable needs a length");
  double stiffness = axial_stiffness(structure);
  const double stiffest = 1e12 * stiffness;
  std::optional<std::vector<springs::Cable>> springs;
  // The softest springs from here on whose rest lengths are positive.
  const auto lay_springs = [&](const Eigen::VectorXd& at) {
    while (!(springs = as_springs(structure, at, stiffness)) && stiffness < stiffest)
      stiffness *= 10;
    return springs.has_value();
  };
  InextensibleEquilibrium result{.tensions = tensions};
  result.equilibrium.state = std::move(start);
  if (!lay_springs(tensions)) return result;
  model::Structure sprung = structure;
  sprung.cables = *springs;
  System system(std::move(sprung));
  Linearisation workspace;
  Equilibrium total;
  for (double last = 1; result.rounds < max_rounds;) {
    ++result.rounds;
    result.equilibrium = solve(system, std::move(result.equilibrium.state), options, workspace);
    add_counts(result.equilibrium, total);
    result.tensions = system.internal_forces(result.equilibrium.state).tension;
    result.stretch =
        stretch_of(structure, cable_lengths(system, result.equilibrium.state), result.tensions);
    // Rounding stops the progress of the tensions before it stops that of the forces.
    const bool done =
        result.stretch <= enough || (result.stretch < 1e-8 && result.stretch > last / 2);
    if (done || !result.equilibrium.usable()) break;
    // Cables along stiff parts of the rods need stiffer springs.
    if (result.stretch > last / 10) stiffness *= 10;
    last = result.stretch;
    if (!lay_springs(result.tensions)) break;
    system.set_cables(*springs);
  }
  result.equilibrium.iterations = total.iterations;
  result.equilibrium.factorisations = total.factorisations;
  result.equilibrium.evaluations = total.evaluations;
  result.equilibrium.escapes = total.escapes;
  if (result.equilibrium.usable() && result.stretch > 1e-8)
    result.equilibrium.reason = Reason::iteration_limit;
  return result;
}

Assessment assess(const model::Structure& structure, const model::State& state,
                  const Eigen::VectorXd& tensions) {
  core::require(tensions.size() == static_cast<Eigen::Index>(structure.cables.size()),
                "assess: needs one tension per cable");
  Assessment result{.tensions = tensions};
  const std::vector<int> taut = taut_cables(tensions);
  for (int c = 0; c < tensions.size(); ++c)
    if (!std::ranges::binary_search(taut, c)) {
      result.slack.push_back(c);
      result.tensions[c] = 0;
    }
  const System system(as_pulling(structure, state, result.tensions));
  const Eigen::VectorXd gradient = gradient_with(system, state, result.tensions);
  const Eigen::VectorXd of_rods = system.rod_gradient(state);
  result.residual = relative_residual(system, gradient, of_rods);
  result.unexplained =
      relative_residual(system, gradient, of_rods, gradient_rounding(system, state));
  const auto [stability, turn] =
      balanced_stability(structure, state, result.tensions, taut, gradient);
  result.stability = stability;
  result.turn = turn;
  return result;
}

model::Certificate Assessment::certificate() const {
  return {.residual = residual,
          .smallest_eigenvalue = stability.smallest_eigenvalue,
          .slack_cables = static_cast<int>(slack.size()),
          .floating_components = stability.floating_components,
          .stable = certified()};
}

}  // namespace tencer::equilibrium
