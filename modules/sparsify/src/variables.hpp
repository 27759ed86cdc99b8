// Which variables a network's cables have in an outer optimization, scaled to comparable size.
#pragma once

#include <vector>

#include "design_problem.hpp"
#include "rounds.hpp"

namespace tencer::sparsify {

// `network` has been rebased to rest_ratio.
std::vector<Variable> design_variables(const network::Network& network, const RoundsSetup& setup,
                                       double rest_ratio);

}  // namespace tencer::sparsify
