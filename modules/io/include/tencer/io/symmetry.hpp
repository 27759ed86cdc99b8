// Rotations and reflections that a scene says its target has.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <variant>

namespace tencer::io {

// By 1 / fold of a turn about the line along `axis`; fold >= 2, axis not zero. point: of the line,
// here and below; not set: the rods' centroid, which every symmetry keeps.
struct Rotation {
  int fold = 2;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  std::optional<Eigen::Vector3d> point = std::nullopt;
};

// In the plane across `normal`, not zero.
struct Reflection {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  std::optional<Eigen::Vector3d> point = std::nullopt;
};

using SymmetryGenerator = std::variant<Rotation, Reflection>;

}  // namespace tencer::io
