// Groups of rods that can be moved rigidly at no cost although something holds the structure.
#pragma once

#include <Eigen/Core>
#include <string>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::certify {

// A turn about the line through a point, or a shift along a direction. A turn about a line that
// also shifts along it (a screw) counts as a turn.
struct RigidMotion {
  bool turns = false;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // unit: of the line, or of the shift
  Eigen::Vector3d point = Eigen::Vector3d::Zero();      // of a turn: on its line, nearest the group
};

// Rods that cables tie together (model::components), and a basis of their rigid motions that
// supports and loads allow. No motions: not given (six, in the plane three), the group moves
// freely.
struct FreeGroup {
  std::vector<int> rods{};
  std::vector<RigidMotion> motions{};
  bool held = false;  // by pins, anchors or loads, though not wholly
};

// The groups that move at no cost, in the order of their first rods. None: everything is held, or
// all rods are one group that nothing holds, which moves as a whole and keeps its shape.
std::vector<FreeGroup> free_groups(const model::Structure& structure, const model::State& state);

// In words, coordinates as they are: "rods A and C turn about the line through (0, 0, 0) along
// (1, 0, 0)". `rods`: how many the structure has.
std::string describe(const FreeGroup& group, std::size_t rods);

}  // namespace tencer::certify
