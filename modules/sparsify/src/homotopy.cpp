#include "homotopy.hpp"

#include <algorithm>
#include <cmath>
#include <tencer/equilibrium/rigid_modes.hpp>
#include <utility>

namespace tencer::sparsify {
namespace {

using network::Network;

constexpr double min_step = 1.0 / 64;  // of the way to the goal

// The cables with their stiffness a part t of the way to the goal's.
std::vector<springs::Cable> between(std::vector<springs::Cable> from,
                                    const std::vector<springs::Cable>& goal, double t) {
  if (t == 1) return goal;
  for (std::size_t i = 0; i < from.size(); ++i)
    from[i].stiffness += t * (goal[i].stiffness - from[i].stiffness);
  return from;
}

// How many rigid motions nothing holds back.
Eigen::Index free_motions(const model::Structure& structure, const model::State& state) {
  Eigen::Index count = 0;
  for (const auto& modes : equilibrium::rigid_modes(equilibrium::System(structure), state))
    count += modes.basis.cols();
  return count;
}

}  // namespace

sensitivity::TrackerOptions follow_options(const network::Control& control) {
  return {.tolerance = control.solve.tolerance,
          .max_correction = 1.0,
          .negligible = 5e-3,
          .smallest_step = 1.0,
          .stop = control.stop};
}

bool holds_as_before(const Network& network, const std::vector<springs::Cable>& cables) {
  constexpr double faint = 1e-6;  // of the largest stiffness, be it that of a rod
  double strongest = 0;
  for (const auto& rod : network.structure.rods)
    strongest = std::max(strongest, rod.section.EI1 / std::pow(rod.length(), 3));
  for (const auto& cable : cables) strongest = std::max(strongest, cable.stiffness);
  model::Structure left = network.structure;
  left.cables = cables;
  std::erase_if(left.cables,
                [&](const auto& cable) { return cable.stiffness <= faint * strongest; });
  return left.cables.size() == cables.size() ||
         free_motions(left, network.state) == free_motions(network.structure, network.state);
}

std::optional<Network> without(const Network& network, const std::vector<int>& cables,
                               const network::Control& control, network::SolveCounts& counts) {
  auto goal = network.structure.cables;
  for (const int i : cables) goal[i].stiffness = 0;
  if (!holds_as_before(network, goal)) return std::nullopt;
  sensitivity::Tracker tracker(network.structure, network.state, follow_options(control));
  counts += {.solves = 1, .iterations = tracker.first().iterations};
  if (!tracker.first().usable() || !tracker.committed().linearisation.regular) return std::nullopt;
  double way = 0;
  double step = 1;
  while (way < 1) {
    const double next = std::min(1.0, way + step);
    const auto trial = tracker.evaluate(between(network.structure.cables, goal, next));
    counts += {.solves = trial.solves, .iterations = trial.equilibrium.iterations};
    if (trial.usable() && tracker.trial().linearisation.regular) {
      tracker.commit();
      way = next;
      step *= 2;
    } else {
      step /= 2;
      if (step < min_step) return std::nullopt;
    }
  }
  Network result{network.structure, tracker.committed().state};
  result.structure.cables = goal;
  std::erase_if(result.structure.cables, [](const auto& cable) { return cable.stiffness == 0; });
  if (result.structure.cables.empty()) return std::nullopt;
  return result;
}

std::optional<Network> pulling_only(Network network, const network::Control& control,
                                    network::SolveCounts& counts) {
  for (;;) {
    const auto idle = idle_cables(network);
    if (idle.empty()) return network;
    auto next = without(network, idle, control, counts);
    if (!next) return std::nullopt;
    network = std::move(*next);
  }
}

}  // namespace tencer::sparsify
