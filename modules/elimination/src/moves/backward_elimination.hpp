// Fewer cables one by one, all others refitted after each.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "state/fitted_network.hpp"

namespace tencer::elimination {

struct Descent {
  double aim_percent = 1.0;  // the largest distance from the target that is wanted in the end
  double diagonal = 1.0;     // of the target's bounding box
  double stability_weight = 0.5;
  double min_unit = 1.0;  // the objective's unit is at least min_unit * aim_percent
  int min_cables = 1;     // the elimination ends with so many cables
  // The elimination ends further from the target than this, in %.
  double max_percent = std::numeric_limits<double>::infinity();
  std::function<void(const FittedNetwork&)> progress{};  // after each removal; may be empty
};

// Takes one orbit out: at once, with more damping, then bit by bit. false: the network does not
// hold without; some of its tension may be gone.
bool remove(FittedNetwork& fitted, int orbit, const RemovalOptions& options);

// The networks on the way, from the first one refitted to the one with the fewest cables; none of
// them is fitted closer than it takes to go on. `fitted` is left at the last.
std::vector<network::Network> eliminate_backward(FittedNetwork& fitted, const Descent& descent,
                                                 const RemovalOptions& options);

}  // namespace tencer::elimination
