// Whether a stretch of a rod can follow its target with no force on it: an elastica.
#pragma once

#include <Eigen/Core>

namespace tencer::lower_bound {

// A stretch of a round rod that is straight at rest and free to twist, in any units.
struct Stretch {
  Eigen::Matrix3Xd target{};     // 3 x n: where its vertices should be
  Eigen::VectorXd rest_lengths;  // n - 1 edges
  double error = 0.0;            // every vertex is within this of its target
  double most_bend = 0.0;        // of a vertex, radians: poses that bend further are left out
  double slenderness = 0.0;      // EA / EI, 1 / length^2
};

// True: no equilibrium of the stretch without forces on its inner vertices is within the error, of
// those in which no vertex bends by more than its most_bend and no edge is longer or shorter than
// at rest by more than most_stretch of itself. This is proven (docs/how-few.md has the proof), with
// a hundredth in hand for rounding. False: not known.
bool needs_force(const Stretch& stretch);

inline constexpr double most_stretch = 0.002;

}  // namespace tencer::lower_bound
