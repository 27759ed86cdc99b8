// Orthogonal matrices that might map a figure onto itself.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "detection/sampled.hpp"

namespace tencer::symmetry {

// continuous: the figure is round about an axis; `matrices` then hold `continuous_fold` rotations
// about it, where any angle would do as well, and are not to be refined.
struct Candidates {
  std::vector<Eigen::Matrix3d> matrices{};
  bool continuous = false;
};

// Every symmetry of the figure about its centroid within the relative tolerance is near one of
// these; most of these are no symmetries.
Candidates candidates(const Sampled& sampled, double tolerance, int continuous_fold);

}  // namespace tencer::symmetry
