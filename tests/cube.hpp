#pragma once

#include <Eigen/Core>

namespace tencer {

// The corners, 3 x 8, of a cube about the origin with edges along the axes.
inline Eigen::Matrix3Xd cube(double half) {
  Eigen::Matrix3Xd corners(3, 8);
  for (int i = 0; i < 8; ++i)
    corners.col(i) << (i & 1 ? half : -half), (i & 2 ? half : -half), (i & 4 ? half : -half);
  return corners;
}

}  // namespace tencer
