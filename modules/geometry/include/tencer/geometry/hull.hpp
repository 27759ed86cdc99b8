// Whether points lie within the convex hull of a few others.
#pragma once

#include <Eigen/Core>

namespace tencer::geometry {

struct [[nodiscard]] Outside {
  int point = -1;         // the point furthest outside; -1: all are within
  double distance = 0.0;  // beyond a face of the hull, > 0
};

// corners: 3 x k, k up to a few dozen (every triple is tried as a face); points: 3 x n. A hull
// without volume holds nothing. planar: all z are taken as equal and the hull is a polygon.
Outside outside_hull(const Eigen::Matrix3Xd& corners, const Eigen::Matrix3Xd& points, bool planar);

}  // namespace tencer::geometry
