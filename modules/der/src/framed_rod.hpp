// The bending vertices of a per-edge rod as framed.hpp wants them.
#pragma once

#include "framed.hpp"

namespace tencer::der {

inline VertexLaw vertex_law(const Rod& rod, int b) {
  const Section& s = rod.section;
  const double voronoi = corner(rod, b).voronoi;
  VertexLaw law{.bend = Eigen::Vector2d(s.EI2, s.EI1) / (2 * voronoi)};
  if (rod.rest_twist.size() > 0) law.rest_twist = rod.rest_twist[b];
  if (rod.rest_curvature.size() > 0) {
    // The rest curvature is given halfway between the two frames.
    const Eigen::Vector2d rest = rod.rest_curvature.col(b);
    const double c = std::cos(law.rest_twist / 2);
    const double d = std::sin(law.rest_twist / 2);
    law.rest_before = {c * rest[0] - d * rest[1], c * rest[1] + d * rest[0]};
    law.rest_after = {c * rest[0] + d * rest[1], c * rest[1] - d * rest[0]};
  }
  if (!is_seam(rod, b) || rod.closing_angle) law.twist_stiffness = s.GJ / voronoi;
  return law;
}

// The prescribed closing angle enters the twist at the seam.
inline double seam_angle(const Rod& rod, int b) {
  return is_seam(rod, b) ? rod.closing_angle.value_or(0.0) : 0.0;
}

inline FramedVertex<double> framed_vertex(const Rod& rod, const RodState& state, int b) {
  const Corner c = corner(rod, b);
  const Eigen::Vector3d e = edge(rod, state.x, c.edge_before);
  const Eigen::Vector3d f = edge(rod, state.x, c.edge_after);
  FramedVertex<double> v;
  v.e_length = e.norm();
  v.f_length = f.norm();
  v.t = e / v.e_length;
  v.u = f / v.f_length;
  const ReferenceFrames& frames = state.frames;
  v.before =
      material_frame<double>(v.t, frames.director.col(c.edge_before), state.theta[c.edge_before]);
  v.after =
      material_frame<double>(v.u, frames.director.col(c.edge_after), state.theta[c.edge_after]);
  v.twist =
      state.theta[c.edge_after] - state.theta[c.edge_before] + frames.twist[b] + seam_angle(rod, b);
  return v;
}

}  // namespace tencer::der
