// What may be symmetric - curves and anchors - and the rotations and reflections a person names.
#pragma once

#include <Eigen/Core>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/geometry/polyline.hpp>
#include <variant>
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

// By 2 pi / fold about the line through `point` along `axis`. fold >= 2, axis of any length > 0.
struct Rotation {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  int fold = 2;
};

// In the plane through `point` across `normal`, of any length > 0.
struct Reflection {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
};

using Generator = std::variant<Rotation, Reflection>;

}  // namespace tencer::symmetry
