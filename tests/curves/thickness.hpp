// How thick a rope a closed curve has room for.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <tencer/geometry/polyline.hpp>

namespace tencer::curves::test {

// The least radius of a circle tangent to one edge of a closed polyline in its midpoint and through
// another's: the radius of the thickest tube about the curve that neither kinks nor meets itself
// (Gonzalez, Maddocks 1999), up to the discretisation. Length over thickness is the ropelength.
inline double thickness(const geometry::Polyline& curve) {
  const Eigen::Matrix3Xd edges = geometry::edge_vectors(curve);
  const Eigen::Matrix3Xd midpoints = curve.points + edges / 2;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < curve.vertices(); ++i) {
    const Eigen::Vector3d tangent = edges.col(i).normalized();
    for (int j = 0; j < curve.vertices(); ++j) {
      if (i == j) continue;
      const Eigen::Vector3d d = midpoints.col(i) - midpoints.col(j);
      const double across = tangent.cross(d).norm();
      if (across > 0) least = std::min(least, d.squaredNorm() / (2 * across));
    }
  }
  return least;
}

}  // namespace tencer::curves::test
