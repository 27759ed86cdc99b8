#include "removal.hpp"

#include <algorithm>
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

}  // namespace

sensitivity::TrackerOptions follow_options(const Control& control) {
  return {.tolerance = control.solve.tolerance,
          .max_correction = 1.0,
          .negligible = 5e-3,
          .stop = control.stop};
}

std::optional<Network> moved(const Network& network, const std::vector<springs::Cable>& goal,
                             const Control& control, Effort& effort) {
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
  // Cables of no stiffness still hold groups of rods together in the solver's eyes.
  if (equilibrium::groups(result.structure) != equilibrium::groups(network.structure))
    return std::nullopt;
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
