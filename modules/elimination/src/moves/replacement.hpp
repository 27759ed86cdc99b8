// Cables taken out whose part others take over.
#pragma once

#include <span>

#include "moves/insertion.hpp"

namespace tencer::elimination {

// Takes `count` cables, from `first` on, out of the network, which has none of its symmetries to
// keep: two of the candidates for each go in before, and the cables lose their tension bit by bit.
// false: one of them could not go; the network is as far as it came.
bool replace(FittedNetwork& fitted, int first, int count,
             std::span<const springs::Cable> candidates, const LocalSearchOptions& search,
             const RemovalOptions& removal);

}  // namespace tencer::elimination
