// Whether the crossings of a closed curve make it a knot.
#pragma once

#include <tencer/fabricate/crossings.hpp>
#include <vector>

namespace tencer::fabricate {

// True is a proof: the Alexander polynomial at one place, modulo a prime, is not what it is for a
// ring. crossings: all of one closed curve with itself in one view, none at a vertex. Time grows
// with the cube of their number.
bool knotted(const std::vector<Crossing>& crossings);

}  // namespace tencer::fabricate
