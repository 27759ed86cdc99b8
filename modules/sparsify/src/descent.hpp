// Fewer cables one by one, all others refitted after each.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "walker.hpp"

namespace tencer::sparsify {

// Distances below this, in % of the target's diagonal, are not told apart.
inline constexpr double finest_percent = 1e-4;

struct DescentOptions {
  double percent = 1.0;   // the largest distance from the target that is wanted in the end
  double diagonal = 1.0;  // of the target's bounding box
  double softness = 0.5;  // see Drive
  double finest = 1.0;    // distances are measured in units of at least finest * percent
  int fewest = 1;         // ends with so many cables
  int tries = 2;          // of different cables before it gives up
  // Ends further from the target than this, in %.
  double hopeless = std::numeric_limits<double>::infinity();
  std::function<void(const Walker&)> progress{};  // after each removal; may be empty
};

// The networks on the way from the walker's, the one with the fewest cables last; none of them is
// fitted closer than it takes to go on. The walker is left at the last.
std::vector<Network> descend(Walker& walker, const DescentOptions& options);

}  // namespace tencer::sparsify
