// The tangent-point energy, which keeps a curve away from itself.
#pragma once

#include <tencer/geometry/polyline.hpp>

namespace tencer::curves {

// Of a closed polyline, times its length so that it is invariant under scaling, too:
//   L sum_{i != j} |T_i x d|^3 / |d|^6 l_i l_j,   d = m_i - m_j,
// with midpoints m, unit tangents T and lengths l of the edges (Yu, Schumacher, Crane, "Repulsive
// curves", 2021, with the exponents 3 and 6). Grows without bound as strands come together.
// gradient: 3 x n. Time grows with n^2.
struct TangentPoint {
  double energy = 0.0;
  Eigen::Matrix3Xd gradient{};
};
TangentPoint tangent_point_energy(const geometry::Polyline& curve);

}  // namespace tencer::curves
