// How a structure stands on level ground: the three vertices that touch it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <tencer/model/state.hpp>

namespace tencer::certify {

struct Support {
  int rod = 0;
  int vertex = 0;
};

struct Stance {
  std::array<Support, 3> feet{};
  Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();  // of length 1, across the ground
};

// Set down as it is, z upwards, the structure rolls over its edges like a solid body until the
// plumb line through its centre of mass is well within what touches the ground: the face of its
// vertices' convex hull that this line leaves by. Where more than three touch, the feet are those
// between which it is best. Not set: there are none, as of what lies in an upright plane.
// weight_per_length: per rod, at rest, in any unit. Throws std::invalid_argument unless every rod
// has a positive one.
std::optional<Stance> stance(const model::Structure& structure, const model::State& state,
                             const Eigen::VectorXd& weight_per_length);

// Where the rods' weight is as if it were in one point; requirements as above.
Eigen::Vector3d centre_of_mass(const model::Structure& structure, const model::State& state,
                               const Eigen::VectorXd& weight_per_length);

}  // namespace tencer::certify
