// Rotations and reflections that a person names.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <variant>

namespace tencer::model {

// By 1 / fold of a turn about the line through `point` along `axis`; fold >= 2, axis of any length
// > 0. point not set, here and below: the rods' centroid, which every symmetry keeps.
struct Rotation {
  int fold = 2;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  std::optional<Eigen::Vector3d> point = std::nullopt;
};

// In the plane through `point` across `normal`, of any length > 0.
struct Reflection {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  std::optional<Eigen::Vector3d> point = std::nullopt;
};

using SymmetryGenerator = std::variant<Rotation, Reflection>;

}  // namespace tencer::model
