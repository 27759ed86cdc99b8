// Shoves of a check, to be looked at.
#pragma once

#include <Eigen/Core>
#include <tencer/model/design.hpp>
#include <vector>

namespace tencer::pipeline {

struct Shove {
  double size = 0.0;   // how far the vertex that moves most is pushed, a length
  bool smooth = true;  // along the lowest vibrations only
  bool rests = true;   // false: it was not found where
  double away = 0.0;   // from the pose, where it comes to rest
  bool back = true;    // it comes to rest in the pose
  // Per rod, 3 x n: pushed, some of what the simulation goes through, which knows no inertia, and
  // at rest.
  std::vector<std::vector<Eigen::Matrix3Xd>> poses{};
};

// The first smooth and the first rough of the largest shoves that check() makes, with inextensible
// cables. None where it makes none. Throws std::invalid_argument unless the design's units are
// known.
std::vector<Shove> shoves(const model::Design& design);

}  // namespace tencer::pipeline
