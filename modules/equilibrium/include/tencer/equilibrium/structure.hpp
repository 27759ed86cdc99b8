// Rods, cables, supports and loads: what stands or falls together (paper section 4).
#pragma once

#include <Eigen/Core>
#include <array>
#include <tencer/der/rod.hpp>
#include <tencer/springs/cable.hpp>
#include <vector>

namespace tencer::equilibrium {

// Coordinates of a vertex held where they are in the starting state.
struct Pin {
  int rod = 0;
  int vertex = 0;
  std::array<bool, 3> axes{true, true, true};  // x, y, z
};

// Forces that stay the same however the structure moves: on the point of a rod at arc length s, as
// springs::OnRod has it, or per rest length all along a rod, such as its weight.
struct PointLoad {
  int rod = 0;
  double s = 0.0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
};
struct LineLoad {
  int rod = 0;
  Eigen::Vector3d force_per_length = Eigen::Vector3d::Zero();
};

struct Structure {
  std::vector<der::Rod> rods{};
  Eigen::Matrix3Xd anchors{};  // 3 x k, fixed points in space
  std::vector<springs::Cable> cables{};
  std::vector<Pin> pins{};
  std::vector<PointLoad> point_loads{};
  std::vector<LineLoad> line_loads{};
  bool planar = false;  // z of every vertex is held
};

// Throws std::invalid_argument, naming the field, when a rod, cable, pin or load is not usable.
void validate(const Structure& structure);

using State = std::vector<der::RodState>;

// One state per rod with vertices at positions[rod], 3 x n each.
State make_state(const Structure& structure, const std::vector<Eigen::Matrix3Xd>& positions);

// Span of a cable at a state.
Eigen::Vector3d span_of(const springs::Stencil& stencil, const State& state);

// Groups of rods that cables tie together: for each rod the number of its group, from 0.
std::vector<int> groups(const Structure& structure);

}  // namespace tencer::equilibrium
