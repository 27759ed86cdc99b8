// The solve that all derivatives of a pose share.
#pragma once

#include <tencer/sensitivity/tracker.hpp>

namespace tencer::sensitivity {

// H^+ b, column by column. Rounding leaves b a rigid part even where it has none in exact
// arithmetic.
inline Eigen::MatrixXd rigid_free_solve(const Configuration& at, Eigen::MatrixXd b) {
  for (Eigen::Index k = 0; k < b.cols(); ++k)
    equilibrium::remove_rigid(at.linearisation.rigid, b.col(k));
  return at.linearisation.solve(b);
}

}  // namespace tencer::sensitivity
