// Cables: where they attach and how they pull (paper section 4, eq. 2 and 3).
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string>
#include <tencer/geometry/arc_length.hpp>
#include <variant>
#include <vector>

namespace tencer::springs {

// A point on a rod at arc length s, measured at rest; any s on a closed rod (it wraps), clamped to
// the rod on an open one.
struct OnRod {
  int rod = 0;
  double s = 0.0;
};

struct AtAnchor {
  int anchor = 0;
};

using End = std::variant<OnRod, AtAnchor>;

// A linear spring: tension k (|d| - l), d the vector between its ends. A tension-only one is slack
// when shorter than l; otherwise it pushes. stiffness: force per length, >= 0; rest_length >= 0.
struct Cable {
  End a;
  End b;
  double stiffness = 0.0;
  double rest_length = 0.0;
  bool tension_only = false;
};

// Throws std::invalid_argument, naming the field, unless the cable refers to rods and anchors that
// exist (rods: how many, anchors: how many), joins two different points and has finite stiffness
// and rest length >= 0.
void validate(const Cable& cable, int rods, int anchors);

// Where it ends, in words: "A at 12.5 - anchor 4".
std::string describe(const Cable& cable);

// A vertex's share in the span of a cable.
struct Share {
  int rod = 0;
  int vertex = 0;
  double weight = 0.0;
};

// The span d = offset + sum of weight * x[rod].col(vertex), pointing from end a to end b. Vertices
// of end a have negative weights; a vertex may occur twice.
struct Stencil {
  std::array<Share, 4> shares{};
  int count = 0;
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};

// rods: the arc lengths of the structure's rods; anchors: 3 x k. At a vertex `side` picks the edge.
// The cable has passed validate() for them.
Stencil stencil(const Cable& cable, std::span<const geometry::ArcLength> rods,
                const Eigen::Matrix3Xd& anchors, geometry::Side side = geometry::Side::after);

// position(rod, vertex) gives the vertex as an Eigen::Vector3d.
template <class Position>
Eigen::Vector3d span_of(const Stencil& stencil, Position&& position) {
  Eigen::Vector3d d = stencil.offset;
  for (int i = 0; i < stencil.count; ++i) {
    const Share& share = stencil.shares[i];
    d += share.weight * position(share.rod, share.vertex);
  }
  return d;
}

}  // namespace tencer::springs
