// A discrete elastic rod at rest, its state, and which unknowns it needs (paper section 4; Bergou
// et al. 2008, 2010).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <tencer/der/section.hpp>

namespace tencer::der {

// The rest state. n vertices; a closed rod has n edges and n bending vertices, an open one n-1
// edges and n-2 bending vertices (1..n-2).
struct Rod {
  bool closed = false;
  Section section;
  Eigen::VectorXd rest_lengths{};  // per edge, length units, positive

  // Per bending vertex, in the material frame: integrated curvature (kb . m2, -kb . m1),
  // dimensionless. Empty: straight at rest.
  Eigen::Matrix2Xd rest_curvature{};
  // Per bending vertex: twist angle between the material frames of its edges at rest, radians.
  // Empty: untwisted.
  Eigen::VectorXd rest_twist{};

  // Closed rods: the angle from the material frame transported once around to the frame it started
  // from, radians. Not set: free, the rod is glued wherever it comes to rest.
  std::optional<double> closing_angle{};
  // Open rods: material frames of the first and last edge held in space (their vertices are pinned
  // by the structure).
  bool clamp_start_frame = false;
  bool clamp_end_frame = false;

  int edges() const { return static_cast<int>(rest_lengths.size()); }
  int vertices() const { return closed ? edges() : edges() + 1; }
  int bending_vertices() const { return closed ? edges() : edges() - 1; }
  // Bending vertex b (0-based) is vertex b of a closed rod and b + 1 of an open one.
  int bending_vertex(int b) const { return closed ? b : b + 1; }
  double length() const { return rest_lengths.sum(); }
};

// Throws std::invalid_argument, naming the field, unless sizes and signs are right: at least 3
// vertices (2 for an open rod), positive stiffnesses and lengths, all finite.
void validate(const Rod& rod);

// How twist enters. A rod that is straight, untwisted and isotropic carries no twist when an end is
// free to spin (none); with a prescribed closing angle its twist is uniform (uniform: one scalar);
// every other rod keeps an angle per edge.
enum class TwistModel { none, uniform, per_edge };
TwistModel twist_model(const Rod& rod);

// Reference frames: unit tangents and, perpendicular to them, one director per edge; material
// frames are these turned by theta. They follow the rod by time-parallel transport.
struct ReferenceFrames {
  Eigen::Matrix3Xd tangent{};   // 3 x edges
  Eigen::Matrix3Xd director{};  // 3 x edges
  Eigen::VectorXd twist{};      // per bending vertex: reference twist, radians, continuous in time
};

// A deformed rod. x: 3 x n. theta and frames are empty unless twist_model is per_edge; holonomy
// (the angle of parallel transport once around, continuous in time) is used when it is uniform.
struct RodState {
  Eigen::Matrix3Xd x{};
  Eigen::VectorXd theta{};
  ReferenceFrames frames{};
  double holonomy = 0.0;
};

// The state with vertices at x. Per-edge rods get untwisted (Bishop) reference frames and theta = 0
// but for the last edge of a closed rod with a closing angle and the clamped end of an open one.
RodState make_state(const Rod& rod, Eigen::Matrix3Xd x);

}  // namespace tencer::der
