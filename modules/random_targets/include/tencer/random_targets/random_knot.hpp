// Random targets with a known solution (paper section 6.2, figure 14): a closed rod at rest under
// random springs.
#pragma once

#include <cstdint>
#include <optional>
#include <tencer/geometry/polyline.hpp>
#include <tencer/springs/cable.hpp>
#include <vector>

namespace tencer::random_targets {

// Lengths in any unit.
struct RandomKnotOptions {
  int cables = 12;
  double length = 200;
  int vertices = 200;
  std::uint64_t seed = 1;
  // Where the curve passes by itself, the least distance and the least radius of curvature,
  // relative to the length.
  double clearance = 0.01;
  int draws = 200;  // tried before giving up
};

struct RandomKnot {
  geometry::Polyline curve{};  // closed, edges of equal length but for the rod's slight stretch
  // The springs of zero rest length that hold an isotropic rod with bending stiffness EI = 1, in
  // the options' unit of length, in this shape.
  std::vector<springs::Cable> cables{};
};

// What is wrong with the options, in words for a user.
std::optional<const char*> random_knot_problem(const RandomKnotOptions& options);

// The stable equilibrium of a closed rod, started from a random smooth loop, under springs of zero
// rest length between random points; drawn again until it keeps the clearance from itself, holds
// its curvature and is not merely a plane curve. None when no draw did. The random numbers of a
// seed are the same on every platform. Requires options without problem.
std::optional<RandomKnot> random_knot(const RandomKnotOptions& options);

}  // namespace tencer::random_targets
