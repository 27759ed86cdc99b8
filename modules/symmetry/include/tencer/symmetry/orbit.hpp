// Orbits of cables: a cable and all its images under a group.
#pragma once

#include <span>
#include <tencer/springs/cable.hpp>
#include <tencer/symmetry/group.hpp>
#include <vector>

namespace tencer::symmetry {

// Two cables are the same when they join the same places, in either order: the same anchors, and
// arc lengths that differ by at most this part of the rod's length. All functions of cables throw
// as springs::validate does.
inline constexpr double same_place = 1e-4;

// The different images of `cable`, itself first. A cable that is nearly one of its own images (it
// ends nearly on a mirror plane, say) is first moved to where it is that image exactly.
std::vector<springs::Cable> orbit(const springs::Cable& cable, const Group& group,
                                  double tolerance = same_place);

// The network with all images of its cables, each once, orbit by orbit in the order of their first
// cables. Stiffness and rest length of an orbit are the means of its cables that were there.
std::vector<springs::Cable> complete(std::span<const springs::Cable> cables, const Group& group,
                                     double tolerance = same_place);

}  // namespace tencer::symmetry
