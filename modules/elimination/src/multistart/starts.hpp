// The networks that a search begins with.
#pragma once

#include <span>
#include <tencer/ground_structure/problem.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <vector>

#include "multistart/multistart.hpp"

namespace tencer::elimination {

// Networks that balance the forces to parts of the error that is accepted. The first row and
// network of `result` are of the first that is valid; failing all, of the first.
std::vector<Start> balanced_starts(const ground_structure::Problem& problem,
                                   const EliminationOptions& options,
                                   const network::Control& control, network::StageResult& result);

// Groups that structure and target nearly have: symmetric networks are found sooner and are often
// good.
std::vector<symmetry::Group> symmetry_seeds(const ground_structure::Problem& problem,
                                            const StartOptions& options);

// Networks of few orbits of each group, side by side; where its few orbits do not hold, one that
// balances the forces. They refer to the groups.
std::vector<Start> symmetric_starts(const ground_structure::Problem& problem,
                                    std::span<const symmetry::Group* const> groups, int max_cables,
                                    const EliminationOptions& options,
                                    const network::Control& control, network::SolveCounts& counts);

// The problem without cables between rods that are no neighbours, unless the rules say which rods
// to join.
ground_structure::Problem among_neighbours_only(ground_structure::Problem problem);

}  // namespace tencer::elimination
