// What taking out a cable is predicted to cost, and how the others make up for it.
#pragma once

#include <optional>
#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/network.hpp>
#include <vector>

#include "refine.hpp"

namespace tencer::sparsify {

struct Removal {
  int cable = 0;
  double cost = 0.0;  // the distance T predicted, relative to the setup's percent
  // All cables as they are predicted to serve best, `cable` with no stiffness.
  std::vector<springs::Cable> refitted{};
};

// The removals of single cables, cheapest first: of the true equilibrium without the cable, less
// what refitting the others gains in a damped Gauss-Newton step. Cables without which the
// equilibrium cannot be followed in one step cost an unknown amount and come last, by tension.
std::vector<Removal> removals(const Network& network, const sensitivity::Target& target,
                              const RefineSetup& setup, const Control& control, Effort& effort);

// The network without a cable that cannot be dropped at once: its stiffness is lowered in steps,
// all others refitted at each. none when the equilibrium is lost all the same.
std::optional<Network> without_gradually(const Network& network, int cable,
                                         const sensitivity::Target& target,
                                         const RefineSetup& setup, const Control& control,
                                         Effort& effort);

}  // namespace tencer::sparsify
