// Forces on rods that stay the same however the rods move.
#pragma once

#include <Eigen/Core>

namespace tencer::io {

// On the point of a rod at arc length s at rest, in [0, length of the rod].
struct PointLoad {
  int rod = 0;
  double s = 0.0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
};

// Per length at rest all along a rod: its weight.
struct LineLoad {
  int rod = 0;
  Eigen::Vector3d force_per_length = Eigen::Vector3d::Zero();
};

}  // namespace tencer::io
