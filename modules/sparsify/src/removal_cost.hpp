// What taking out a cable is predicted to cost.
#pragma once

#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/network.hpp>
#include <vector>

#include "refine.hpp"

namespace tencer::sparsify {

// Cables in the order of the distance T that is predicted without them: of the true equilibrium
// without the cable, less what refitting the others gains to first order. Cables without which the
// equilibrium cannot be followed in one step come last.
std::vector<int> by_removal_cost(const Network& network, const sensitivity::Target& target,
                                 const RefineSetup& setup, const Control& control, Effort& effort);

}  // namespace tencer::sparsify
