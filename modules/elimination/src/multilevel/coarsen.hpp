// The same problem on fewer vertices, where a search takes a fraction of the time.
#pragma once

#include <optional>
#include <tencer/elimination/options.hpp>
#include <tencer/ground_structure/problem.hpp>

namespace tencer::elimination {

// With just as many vertices on each rod as its turns need; none when that would save little. Rods
// that need angles of twist, or are pinned other than at their ends, stay as they are.
std::optional<ground_structure::Problem> coarsened(const ground_structure::Problem& problem,
                                                   const CoarseOptions& options);

}  // namespace tencer::elimination
