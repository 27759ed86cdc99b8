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

  // Per bending vertex: integrated curvature (kb . m2, -kb . m1), dimensionless, in the frame
  // halfway between the material frames of its two edges at rest. kb, the discrete curvature
  // binormal, has length 2 tan(turning angle / 2). The first component, bending about m2, is
  // resisted by EI2, the second by EI1. Empty: straight at rest.
  Eigen::Matrix2Xd rest_curvature{};
  // Per bending vertex: twist angle at rest from the material frame of the edge before (carried
  // across by parallel transport) to that of the edge after, radians. Empty: untwisted.
  Eigen::VectorXd rest_twist{};

  // Closed rods: the angle about the tangent, radians and possibly many turns, by which the
  // material frame at the end of the rod is turned against the frame it started from where the two
  // are glued (the seam, at vertex 0). A flat ring with closing angle 0 is untwisted, and in
  // general the rod's total twist is the closing angle less the holonomy. Not set: free, the rod is
  // glued wherever it comes to rest. The seam then bends like any other vertex but transmits no
  // twisting moment.
  std::optional<double> closing_angle{};
  // Open rods: material frames of the first and last edge held, so that theta of that edge is no
  // free unknown; the edge's vertices are pinned by the structure.
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

// Makes the curve x (3 x n) with material directors m1 (3 x edges, as far as perpendicular to the
// edges) the rest shape: rest_lengths, rest_curvature and rest_twist (each in [-pi, pi]). Throws
// std::invalid_argument when the numbers of vertices and directors do not fit.
void set_rest_shape(Rod& rod, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& m1);

// How twist enters. An isotropic rod that is straight at rest carries no twist when an end is free
// to spin (none), whatever its rest twist; with a prescribed closing angle its twist is uniform
// (uniform: one scalar); every other rod keeps an angle per edge.
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
// (the angle about the tangent by which parallel transport once around turns a frame, continuous in
// time) is used when it is uniform. Frames and holonomy belong to x: move a state by displace()
// only.
struct RodState {
  Eigen::Matrix3Xd x{};
  Eigen::VectorXd theta{};
  ReferenceFrames frames{};
  double holonomy = 0.0;
};

// The state with vertices at x. Per-edge rods get untwisted (Bishop) reference frames, starting
// from a director that is a function of the first tangent alone, and the theta that a twist by
// rest_twist gives: 0 along an untwisted open rod, also at clamped ends (set_material_frame sets
// others). With a closing angle the remaining twist is spread evenly. The initial holonomy is in
// [-pi, pi], so a closing angle counts its turns from there. Throws std::invalid_argument unless x
// has a column for each vertex.
RodState make_state(const Rod& rod, Eigen::Matrix3Xd x);

// Columns m1, m2, tangent of an edge. This and the next throw std::invalid_argument for rods that
// keep no angle per edge and for edges that they do not have.
Eigen::Matrix3d material_frame(const RodState& state, int edge);
// Turns theta of `edge`, by at most half a turn, so that m1 is as given, as far as it is
// perpendicular to the edge. Throws std::invalid_argument for an m1 along the edge, to 1e-8.
void set_material_frame(RodState& state, int edge, const Eigen::Vector3d& m1);

}  // namespace tencer::der
