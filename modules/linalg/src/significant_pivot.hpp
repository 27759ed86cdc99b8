// When a pivot of L D L^T says nothing but rounding.
#pragma once

#include <cmath>
#include <limits>

namespace tencer::linalg {

// A pivot D_j = A_jj - sum_k L_jk^2 D_k is known to about the rounding of the terms subtracted.
// Unlike a limit relative to the largest entry this does not depend on how unknowns are scaled.
inline bool is_significant_pivot(double magnitude, double subtracted) {
  return std::isfinite(magnitude) && magnitude > 0.0 &&
         magnitude > 16.0 * std::numeric_limits<double>::epsilon() * subtracted;
}

}  // namespace tencer::linalg
