// Where the cables of a design run.
#pragma once

#include <tencer/model/design.hpp>
#include <vector>

namespace tencer::model {

// Of every cable the straight line from end a to end b at the pose, in the design's length unit.
std::vector<geometry::Polyline> cable_lines(const Design& design);

}  // namespace tencer::model
