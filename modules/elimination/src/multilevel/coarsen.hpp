// The same problem on fewer vertices, where a search takes a fraction of the time.
#pragma once

#include <optional>
#include <tencer/elimination/options.hpp>
#include <tencer/ground_structure/problem.hpp>

namespace tencer::elimination {

// Whether a rod can be cut into other edges: it needs no angles of twist, and is not pinned other
// than at its ends.
bool alike_all_along(const model::Structure& structure, int rod);

// With just as many vertices on each rod as its turns need, or as many as there are when that would
// save little. Its numbers are rounded, to a small part of an edge and to seven digits, so that
// shapes that differ by no more than rounding errors are searched as one. None when no rod can be
// cut into other edges.
std::optional<ground_structure::Problem> coarsened(const ground_structure::Problem& problem,
                                                   const CoarseOptions& options);

double rounded(double x);  // to seven digits
Workmanship rounded(Workmanship workmanship);

}  // namespace tencer::elimination
