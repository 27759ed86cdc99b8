#include "removal.hpp"

#include <algorithm>
#include <utility>

namespace tencer::sparsify {
namespace {

constexpr double shortest_step = 1.0 / 64;  // of the way from full stiffness to none

}  // namespace

sensitivity::TrackerOptions follow_options(const Control& control) {
  return {.tolerance = control.solve.tolerance,
          .max_correction = 1.0,
          .negligible = 5e-3,
          .stop = control.stop};
}

std::optional<Network> without(const Network& network, const std::vector<int>& cables,
                               const Control& control, Effort& effort) {
  sensitivity::Tracker tracker(network.structure, network.state, follow_options(control));
  ++effort.solves;
  effort.iterations += tracker.first().iterations;
  if (!tracker.first().usable() || !tracker.committed().linearisation.regular) return std::nullopt;
  double gone = 0;
  double step = 1;
  while (gone < 1) {
    const double next = std::min(1.0, gone + step);
    auto changed = network.structure.cables;
    for (const int i : cables) changed[i].stiffness *= 1 - next;
    const auto trial = tracker.evaluate(std::move(changed));
    effort.solves += trial.solves;
    effort.iterations += trial.equilibrium.iterations;
    if (trial.usable() && tracker.trial().linearisation.regular) {
      tracker.commit();
      gone = next;
      step *= 2;
    } else {
      step /= 2;
      if (step < shortest_step) return std::nullopt;
    }
  }

  Network result{network.structure, tracker.committed().state};
  std::vector<springs::Cable> left;
  for (int i = 0; i < static_cast<int>(network.structure.cables.size()); ++i)
    if (std::ranges::find(cables, i) == cables.end()) left.push_back(network.structure.cables[i]);
  if (left.empty()) return std::nullopt;
  result.structure.cables = std::move(left);
  // Cables of no stiffness still hold groups of rods together in the solver's eyes.
  if (equilibrium::groups(result.structure) != equilibrium::groups(network.structure))
    return std::nullopt;
  return result;
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
