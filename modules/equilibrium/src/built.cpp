#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/built.hpp>

#include "balanced_stability.hpp"
#include "forces.hpp"

namespace tencer::equilibrium {
namespace {

Eigen::VectorXd lengths_of(const System& system, const State& state) {
  Eigen::VectorXd lengths(static_cast<Eigen::Index>(system.stencils().size()));
  for (std::size_t c = 0; c < system.stencils().size(); ++c)
    lengths[static_cast<Eigen::Index>(c)] = span_of(system.stencils()[c], state).norm();
  return lengths;
}

// The gradient of the rods' energy plus what cables of these tensions exert.
Eigen::VectorXd gradient_with(const System& system, const State& state,
                              const Eigen::VectorXd& tensions) {
  Eigen::VectorXd gradient = system.rod_gradient(state);
  for (std::size_t c = 0; c < system.stencils().size(); ++c) {
    const auto& stencil = system.stencils()[c];
    const Eigen::Vector3d pull =
        tensions[static_cast<Eigen::Index>(c)] * span_of(stencil, state).normalized();
    for (int i = 0; i < stencil.count; ++i)
      for (int axis = 0; axis < 3; ++axis)
        if (const int at =
                system.position_index(stencil.shares[i].rod, stencil.shares[i].vertex, axis);
            at >= 0)
          gradient[at] += stencil.shares[i].weight * pull[axis];
  }
  return gradient;
}

}  // namespace

BuiltForm settle(const Structure& structure, State start, const SolveOptions& options) {
  constexpr int max_rounds = 30;
  constexpr double enough = 1e-10;
  Structure springs = structure;
  double stiffness = 0;  // as stiff as the stiffest rod is along its axis
  for (const auto& rod : structure.rods)
    stiffness = std::max(stiffness, rod.section.EA / rod.length());
  for (auto& cable : springs.cables) {
    core::require(cable.rest_length > 0, "settle: every cable needs a length");
    cable.stiffness = stiffness;
    cable.tension_only = true;
  }
  System system(springs);
  Linearisation workspace;
  BuiltForm built;
  const auto count = static_cast<Eigen::Index>(structure.cables.size());
  built.tensions = Eigen::VectorXd::Zero(count);
  built.equilibrium.state = std::move(start);
  int iterations = 0;
  int factorisations = 0;
  int evaluations = 0;
  int escapes = 0;
  for (double last = 1; built.rounds < max_rounds;) {
    ++built.rounds;
    built.equilibrium = solve(system, std::move(built.equilibrium.state), options, workspace);
    iterations += built.equilibrium.iterations;
    factorisations += built.equilibrium.factorisations;
    evaluations += built.equilibrium.evaluations;
    escapes += built.equilibrium.escapes;
    built.tensions = system.internal_forces(built.equilibrium.state).tension;
    const Eigen::VectorXd lengths = lengths_of(system, built.equilibrium.state);
    built.stretch = 0;
    for (Eigen::Index c = 0; c < count; ++c)
      built.stretch = std::max(built.stretch, lengths[c] / structure.cables[c].rest_length - 1);
    // Rounding stops the progress of the tensions before it stops that of the forces.
    const bool done = built.stretch <= enough || (built.stretch < 1e-8 && built.stretch > last / 2);
    if (done || !built.equilibrium.usable()) break;
    // Cables along stiff parts of the rods need stiffer springs.
    if (built.stretch > last / 10) stiffness *= 10;
    last = built.stretch;
    for (Eigen::Index c = 0; c < count; ++c) {
      springs.cables[c].stiffness = stiffness;
      springs.cables[c].rest_length =
          structure.cables[c].rest_length - built.tensions[c] / stiffness;
    }
    system.set_cables(springs.cables);
  }
  built.equilibrium.iterations = iterations;
  built.equilibrium.factorisations = factorisations;
  built.equilibrium.evaluations = evaluations;
  built.equilibrium.escapes = escapes;
  if (built.equilibrium.usable() && built.stretch > 1e-8)
    built.equilibrium.reason = Reason::iteration_limit;
  return built;
}

Certificate certify(const Structure& structure, const State& state,
                    const Eigen::VectorXd& tensions) {
  constexpr double slack_tension = 1e-9;
  core::require(tensions.size() == static_cast<Eigen::Index>(structure.cables.size()),
                "certify: needs one tension per cable");
  Certificate certificate{.tensions = tensions};
  const double largest = tensions.size() > 0 ? tensions.maxCoeff() : 0;
  std::vector<int> taut;
  for (int c = 0; c < tensions.size(); ++c) {
    if (tensions[c] > slack_tension * largest) {
      taut.push_back(c);
    } else {
      certificate.slack.push_back(c);
      certificate.tensions[c] = 0;
    }
  }
  const System system(structure);
  const Eigen::VectorXd gradient = gradient_with(system, state, certificate.tensions);
  certificate.residual = relative_residual(system, gradient, system.rod_gradient(state));
  const auto [stability, turn] =
      balanced_stability(structure, state, certificate.tensions, taut, gradient);
  certificate.stability = stability;
  certificate.turn = turn;
  return certificate;
}

}  // namespace tencer::equilibrium
