// Few cables without a network to start from: the forces balanced at the target, then cables
// eliminated, on fewer vertices first where that saves time.
#pragma once

#include <span>
#include <tencer/elimination/options.hpp>
#include <tencer/elimination/solution.hpp>
#include <tencer/ground_structure/problem.hpp>

namespace tencer::elimination {

// symmetry_seeds: groups that structure and target nearly have. Some networks are given them to
// begin with, since symmetric networks are found sooner and are often good; the result need not
// have them. Not looked at when the problem has a symmetry of its own. Throws std::invalid_argument
// for wrong options or rules.
EliminationResult search(const ground_structure::Problem& problem,
                         std::span<const symmetry::Group> symmetry_seeds,
                         const EliminationOptions& options = {},
                         const network::Control& control = {});

}  // namespace tencer::elimination
