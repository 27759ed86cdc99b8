// What must be laid through what before the ends of closed rods are joined: afterwards it is too
// late.
#pragma once

#include <span>
#include <tencer/geometry/polyline.hpp>
#include <vector>

namespace tencer::fabricate {

// Two closed rods of which one may have to go through the other: no plane lies between them.
struct ThreadedPair {
  int a = 0;
  int b = 0;
  // Not 0: they cannot be made apart. 0: it does not tell; one may lie within the other, or go
  // through it and back, or a third rod hold both (as Borromean rings do).
  int linking_number = 0;
};

struct Threading {
  // One entry a rod, for closed ones: not a ring, by its Alexander polynomial at one place. A rod
  // of which this is not true may be a knot all the same (the simplest such has eleven crossings).
  std::vector<bool> knotted{};
  std::vector<ThreadedPair> pairs{};
};

// The rods do not meet. Planes are tried in a few hundred directions.
Threading threading(std::span<const geometry::Polyline> rods);

}  // namespace tencer::fabricate
