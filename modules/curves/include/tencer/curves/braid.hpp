// Closed braids as curves: a way to write down any knot in a few integers (Alexander 1923).
#pragma once

#include <span>
#include <tencer/geometry/polyline.hpp>

namespace tencer::curves {

// The closure of a braid about the z axis. A letter k > 0 of the word exchanges the strands at
// places k and k + 1, counted from 1 outwards, the one that goes outwards above the other; -k is
// the mirror image. Strands are a distance 1 apart in the plane and at crossings; the points are
// dense enough to be joined by straight edges, but not evenly spaced. Throws std::invalid_argument
// unless there are two strands and a letter, 1 <= |k| < strands, and the closure is one curve.
geometry::Polyline braid_closure(int strands, std::span<const int> word);

}  // namespace tencer::curves
