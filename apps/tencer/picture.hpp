// Drawings of a design, and of a motion that no cables keep rods from.
#pragma once

#include <string>
#include <tencer/io/design.hpp>
#include <tencer/model/feasibility.hpp>

namespace tencer::app {

// SVG: rods as thick strokes that leave a gap where they pass over others, cables as thin ones,
// anchors as squares; seen obliquely along the direction in which the pose extends least. Follows
// the reader's light or dark scheme. Requires at least one rod and finite coordinates.
std::string picture_svg(const model::Design& design);

// The targets, likewise, with an arrow from a vertex to where the rods take it, enlarged where they
// hardly move.
std::string picture_svg(const model::Feasibility& feasibility);

}  // namespace tencer::app
