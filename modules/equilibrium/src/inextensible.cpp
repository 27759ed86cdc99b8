#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/constrained.hpp>
#include <tencer/equilibrium/inextensible.hpp>

#include "balanced_stability.hpp"
#include "forces.hpp"

namespace tencer::equilibrium {
namespace {

Eigen::VectorXd lengths_of(const System& system, const model::State& state) {
  Eigen::VectorXd lengths(static_cast<Eigen::Index>(system.stencils().size()));
  for (std::size_t c = 0; c < system.stencils().size(); ++c)
    lengths[static_cast<Eigen::Index>(c)] = model::span_of(system.stencils()[c], state).norm();
  return lengths;
}

// The gradient of the rods' energy plus what cables of these tensions exert.
Eigen::VectorXd gradient_with(const System& system, const model::State& state,
                              const Eigen::VectorXd& tensions) {
  Eigen::VectorXd gradient = system.rod_gradient(state);
  for (std::size_t c = 0; c < system.stencils().size(); ++c) {
    const auto& stencil = system.stencils()[c];
    const Eigen::Vector3d pull =
        tensions[static_cast<Eigen::Index>(c)] * model::span_of(stencil, state).normalized();
    system.for_each_unknown(
        stencil, [&](int at, int axis, double weight) { gradient[at] += weight * pull[axis]; });
  }
  return gradient;
}

}  // namespace

InextensibleEquilibrium relax_inextensible(const model::Structure& structure, model::State start,
                                           const SolveOptions& options) {
  constexpr int max_rounds = 30;
  constexpr double enough = 1e-10;
  model::Structure springs = structure;
  double stiffness = 0;  // as stiff as the stiffest rod is along its axis
  for (const auto& rod : structure.rods)
    stiffness = std::max(stiffness, rod.section.EA / rod.length());
  for (auto& cable : springs.cables) {
    core::require(cable.rest_length > 0, "relax_inextensible: every cable needs a length");
    cable.stiffness = stiffness;
    cable.tension_only = true;
  }
  System system(springs);
  Linearisation workspace;
  InextensibleEquilibrium result;
  const auto count = static_cast<Eigen::Index>(structure.cables.size());
  result.tensions = Eigen::VectorXd::Zero(count);
  result.equilibrium.state = std::move(start);
  int iterations = 0;
  int factorisations = 0;
  int evaluations = 0;
  int escapes = 0;
  for (double last = 1; result.rounds < max_rounds;) {
    ++result.rounds;
    result.equilibrium = solve(system, std::move(result.equilibrium.state), options, workspace);
    iterations += result.equilibrium.iterations;
    factorisations += result.equilibrium.factorisations;
    evaluations += result.equilibrium.evaluations;
    escapes += result.equilibrium.escapes;
    result.tensions = system.internal_forces(result.equilibrium.state).tension;
    const Eigen::VectorXd lengths = lengths_of(system, result.equilibrium.state);
    result.stretch = 0;
    for (Eigen::Index c = 0; c < count; ++c)
      result.stretch = std::max(result.stretch, lengths[c] / structure.cables[c].rest_length - 1);
    // Rounding stops the progress of the tensions before it stops that of the forces.
    const bool done =
        result.stretch <= enough || (result.stretch < 1e-8 && result.stretch > last / 2);
    if (done || !result.equilibrium.usable()) break;
    // Cables along stiff parts of the rods need stiffer springs, and no spring may need a negative
    // rest length for its tension.
    if (result.stretch > last / 10) stiffness *= 10;
    for (Eigen::Index c = 0; c < count; ++c)
      while (result.tensions[c] > stiffness * structure.cables[c].rest_length) stiffness *= 10;
    last = result.stretch;
    for (Eigen::Index c = 0; c < count; ++c) {
      springs.cables[c].stiffness = stiffness;
      springs.cables[c].rest_length =
          structure.cables[c].rest_length - result.tensions[c] / stiffness;
    }
    system.set_cables(springs.cables);
  }
  result.equilibrium.iterations = iterations;
  result.equilibrium.factorisations = factorisations;
  result.equilibrium.evaluations = evaluations;
  result.equilibrium.escapes = escapes;
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
  const System system(structure);
  const Eigen::VectorXd gradient = gradient_with(system, state, result.tensions);
  result.residual = relative_residual(system, gradient, system.rod_gradient(state));
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
