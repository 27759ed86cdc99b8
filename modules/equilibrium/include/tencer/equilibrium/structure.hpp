// Rods, cables and supports: what stands or falls together (paper section 4).
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

struct Structure {
  std::vector<der::Rod> rods{};
  Eigen::Matrix3Xd anchors{};  // 3 x k, fixed points in space
  std::vector<springs::Cable> cables{};
  std::vector<Pin> pins{};
  bool planar = false;  // z of every vertex is held
};

// Throws std::invalid_argument, naming the field, when a rod, cable or pin is not usable.
void validate(const Structure& structure);

using State = std::vector<der::RodState>;

// One state per rod with vertices at positions[rod], 3 x n each.
State make_state(const Structure& structure, const std::vector<Eigen::Matrix3Xd>& positions);

// Span of a cable at a state.
Eigen::Vector3d span_of(const springs::Stencil& stencil, const State& state);

// Groups of rods that cables tie together: for each rod the number of its group, from 0.
std::vector<int> groups(const Structure& structure);

}  // namespace tencer::equilibrium
