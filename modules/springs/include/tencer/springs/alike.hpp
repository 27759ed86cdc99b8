// Cables that join nearly the same places.
#pragma once

#include <tencer/springs/cable.hpp>

namespace tencer::springs {

// Whether two cables do, in either order: the same anchors, and arc lengths less than `part` of the
// rod's length apart. rods: the arc lengths of the rods that the cables are on.
bool alike(const Cable& one, const Cable& other, std::span<const geometry::ArcLength> rods,
           double part);

}  // namespace tencer::springs
