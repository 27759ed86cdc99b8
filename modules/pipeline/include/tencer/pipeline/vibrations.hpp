// How a design vibrates about its pose.
#pragma once

#include <Eigen/Core>
#include <tencer/model/design.hpp>
#include <vector>

namespace tencer::pipeline {

struct Vibration {
  double hertz = 0.0;  // 0: a motion that costs nothing
  // Per rod, 3 x n: where the vertices move, the largest component 1.
  std::vector<Eigen::Matrix3Xd> shape{};
};

// The `count` lowest, ascending (certify/modes.hpp), with the rods' own mass and cables that do not
// stretch; fewer of a design that has fewer. None where they cannot be found. Throws
// std::invalid_argument unless count >= 1 and the design's units are known.
std::vector<Vibration> vibrations(const model::Design& design, int count);

}  // namespace tencer::pipeline
