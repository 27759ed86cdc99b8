// A number of cables that no network of a target can do without, from the target alone.
#pragma once

#include <stop_token>
#include <tencer/model/at_least.hpp>
#include <tencer/model/structure.hpp>
#include <tencer/model/target.hpp>

namespace tencer::lower_bound {

// How many cables every equilibrium of the structure's rods has that is within error_percent of the
// target's size at each vertex of weight > 0; its own cables do not count. Of rods that are
// straight at rest, alike to all sides and free to twist; any number of cables may do for others,
// and for rods with line loads. Poses are left out in which a vertex bends by more than twice as
// much as any of the target's, and by more than 0.1 radians, or an edge is strained by more than
// 0.2 %. Units are the structure's. After a stop it is what was proven until then. Throws
// std::invalid_argument unless the target fits the structure, has no views (what lies along them
// may be anywhere) and the error is positive.
model::AtLeast at_least(const model::Structure& structure, const model::Target& target,
                        double error_percent, const std::stop_token& stop = {});

}  // namespace tencer::lower_bound
