#include "removal.hpp"

#include <algorithm>
#include <cmath>
#include <tencer/equilibrium/rigid_modes.hpp>
#include <utility>

namespace tencer::sparsify {
namespace {

constexpr double shortest_step = 1.0 / 64;  // of the way to the goal

springs::End between(const springs::End& from, const springs::End& to, double t) {
  const auto* a = std::get_if<springs::OnRod>(&from);
  if (!a) return from;
  return springs::OnRod{a->rod, a->s + t * (std::get<springs::OnRod>(to).s - a->s)};
}

std::vector<springs::Cable> between(std::vector<springs::Cable> from,
                                    const std::vector<springs::Cable>& to, double t) {
  if (t == 1) return to;
  for (std::size_t i = 0; i < from.size(); ++i) {
    from[i].a = between(from[i].a, to[i].a, t);
    from[i].b = between(from[i].b, to[i].b, t);
    from[i].stiffness += t * (to[i].stiffness - from[i].stiffness);
  }
  return from;
}

// Rigid motions of groups of rods that nothing holds back.
Eigen::Index free_motions(const equilibrium::Structure& structure,
                          const equilibrium::State& state) {
  Eigen::Index count = 0;
  for (const auto& modes : equilibrium::rigid_modes(equilibrium::System(structure), state))
    count += modes.basis.cols();
  return count;
}

}  // namespace

sensitivity::TrackerOptions follow_options(const Control& control) {
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
  equilibrium::Structure left = network.structure;
  left.cables = cables;
  std::erase_if(left.cables,
                [&](const auto& cable) { return cable.stiffness <= faint * strongest; });
  return left.cables.size() == cables.size() ||
         free_motions(left, network.state) == free_motions(network.structure, network.state);
}

std::optional<Network> moved(const Network& network, const std::vector<springs::Cable>& goal,
                             const Control& control, Effort& effort) {
  if (!holds_as_before(network, goal)) return std::nullopt;
  sensitivity::Tracker tracker(network.structure, network.state, follow_options(control));
  ++effort.solves;
  effort.iterations += tracker.first().iterations;
  if (!tracker.first().usable() || !tracker.committed().linearisation.regular) return std::nullopt;
  double way = 0;
  double step = 1;
  while (way < 1) {
    const double next = std::min(1.0, way + step);
    const auto trial = tracker.evaluate(between(network.structure.cables, goal, next));
    effort.solves += trial.solves;
    effort.iterations += trial.equilibrium.iterations;
    if (trial.usable() && tracker.trial().linearisation.regular) {
      tracker.commit();
      way = next;
      step *= 2;
    } else {
      step /= 2;
      if (step < shortest_step) return std::nullopt;
    }
  }

  Network result{network.structure, tracker.committed().state};
  result.structure.cables = goal;
  std::erase_if(result.structure.cables, [](const auto& cable) { return cable.stiffness == 0; });
  if (result.structure.cables.empty()) return std::nullopt;
  return result;
}

std::optional<Network> without(const Network& network, const std::vector<int>& cables,
                               const Control& control, Effort& effort) {
  auto goal = network.structure.cables;
  for (const int i : cables) goal[i].stiffness = 0;
  return moved(network, goal, control, effort);
}

std::optional<Network> pulling_only(Network network, const Control& control, Effort& effort) {
  for (;;) {
    const auto idle = idle_cables(network);
    if (idle.empty()) return network;
    auto next = without(network, idle, control, effort);
    if (!next) return std::nullopt;
    network = std::move(*next);
  }
}

}  // namespace tencer::sparsify
