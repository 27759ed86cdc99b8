// What may be symmetric: curves and anchors.
#pragma once

#include <Eigen/Core>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/geometry/polyline.hpp>
#include <vector>

namespace tencer::symmetry {

// curves and rods: one each a rod, its target and its arc length at rest (as many edges). anchors:
// 3 x k. classes: one a rod, or none when all are alike; a rod goes only to rods of its own class,
// so rods that differ in section or weight need different classes. Nothing here can tell that a rod
// differs from place to place: leave out operations (Operation::rods) that move it onto itself.
struct Figure {
  std::vector<geometry::Polyline> curves{};
  std::vector<geometry::ArcLength> rods{};
  Eigen::Matrix3Xd anchors{3, 0};
  std::vector<int> classes{};
};

// Throws std::invalid_argument unless the parts of `figure` fit together; needs at least one rod.
void validate(const Figure& figure);

// The centroid of the rods' length, which every symmetry keeps; what is zero but for rounding is 0.
Eigen::Vector3d centroid(const Figure& figure);

}  // namespace tencer::symmetry
