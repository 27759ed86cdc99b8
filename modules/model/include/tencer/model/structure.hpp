// Rods, cables, supports and loads: what stands or falls together (paper section 4).
#pragma once

#include <Eigen/Core>
#include <array>
#include <tencer/der/rod.hpp>
#include <tencer/model/material.hpp>
#include <tencer/springs/cable.hpp>
#include <vector>

namespace tencer::model {

// Coordinates of a vertex that are held where they are in the starting state.
struct Pin {
  int rod = 0;
  int vertex = 0;
  std::array<bool, 3> axes{true, true, true};  // x, y, z
};

// A force that stays the same however the structure moves, on the point of a rod at arc length s at
// rest (springs::OnRod says how s is read). The two vertices of its edge share it linearly.
struct PointLoad {
  int rod = 0;
  double s = 0.0;                                   // a length
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // a force
};

// A force per length at rest all along a rod, such as its weight. The two vertices of an edge share
// the edge's part equally.
struct LineLoad {
  int rod = 0;
  Eigen::Vector3d force_per_length = Eigen::Vector3d::Zero();
};

// Lengths and forces are in any units, the same throughout. Solvers work best in scaled ones, see
// scaling.hpp.
struct Structure {
  std::vector<der::Rod> rods{};
  std::vector<Material> materials{};  // one a rod, or none: not known, which no solver minds
  Eigen::Matrix3Xd anchors = Eigen::Matrix3Xd(3, 0);  // 3 x k, fixed points in space
  std::vector<springs::Cable> cables{};
  std::vector<Pin> pins{};
  std::vector<PointLoad> point_loads{};
  std::vector<LineLoad> line_loads{};
  bool planar = false;  // z of every vertex is held
};

// Throws std::invalid_argument, naming the field, when a rod, cable, pin or load is not usable.
void validate(const Structure& structure);

// The arc length at rest of every rod.
std::vector<geometry::ArcLength> arc_lengths(const Structure& structure);

// The rods' length at rest, altogether.
double total_length(const Structure& structure);

// Whether an end of the cable is at an anchor.
bool is_external(const springs::Cable& cable);

// The components that cables tie rods into: for each rod the number of its component, from 0 in the
// order of their first rods.
std::vector<int> components(const Structure& structure);

}  // namespace tencer::model
