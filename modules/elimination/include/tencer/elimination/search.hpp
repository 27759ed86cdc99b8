// Few cables without a network to start from: the forces balanced at the target, then cables
// eliminated, on fewer vertices first where that saves time.
#pragma once

#include <tencer/elimination/options.hpp>
#include <tencer/elimination/solution.hpp>
#include <tencer/ground_structure/problem.hpp>

namespace tencer::elimination {

// The same shape gives the same cables, however it lies in space and from wherever its rods are
// counted; unless it has a symmetry to keep, or rods whose sides differ. Throws
// std::invalid_argument for wrong options or rules.
EliminationResult search(const ground_structure::Problem& problem,
                         const EliminationOptions& options = {},
                         const network::Control& control = {});

}  // namespace tencer::elimination
