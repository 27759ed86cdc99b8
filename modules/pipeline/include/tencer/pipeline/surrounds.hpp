// Whether anchors surround what they are to hold.
#pragma once

#include <Eigen/Core>

namespace tencer::pipeline {

struct [[nodiscard]] Outside {
  int point = -1;         // the point furthest outside; -1: all are within
  double distance = 0.0;  // from the convex hull, > 0; infinite when the hull holds nothing
};

// Which of the points (3 x n) is furthest outside the convex hull of the anchors (3 x k). A point
// is within up to a millionth of the hull's size. A hull without volume, as that of anchors in a
// plane, holds nothing. planar: all z are taken as equal and the hull is a polygon. Time grows with
// n k.
Outside furthest_outside(const Eigen::Matrix3Xd& anchors, const Eigen::Matrix3Xd& points,
                         bool planar);

}  // namespace tencer::pipeline
