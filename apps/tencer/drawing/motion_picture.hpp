// A picture of the motion that no cables keep rods from.
#pragma once

#include <string>
#include <tencer/model/feasibility.hpp>

namespace tencer::app {

// SVG of the targets, drawn as designs are, with an arrow from a vertex to where the rods take it,
// enlarged where they hardly move. Requires at least one target.
std::string motion_picture(const model::Feasibility& feasibility);

}  // namespace tencer::app
