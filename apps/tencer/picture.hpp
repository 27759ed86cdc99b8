// A drawing of a design.
#pragma once

#include <string>
#include <tencer/io/design.hpp>

namespace tencer::app {

// SVG: rods as thick strokes that leave a gap where they pass over others, cables as thin ones,
// anchors as squares; seen obliquely along the direction in which the pose extends least. Follows
// the reader's light or dark scheme. Requires at least one rod and finite coordinates.
std::string picture_svg(const model::Design& design);

}  // namespace tencer::app
