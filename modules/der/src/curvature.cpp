#include <tencer/der/curvature.hpp>

#include "framed_rod.hpp"

namespace tencer::der {

Eigen::Matrix2Xd bending_curvature(const Rod& rod, const RodState& state) {
  const bool framed = twist_model(rod) == TwistModel::per_edge;
  Eigen::Matrix2Xd curvature = Eigen::Matrix2Xd::Zero(2, rod.bending_vertices());
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const Corner c = corner(rod, b);
    if (framed) {
      curvature.col(b) =
          vertex_curvature(framed_vertex(rod, state, b)).before - vertex_law(rod, b).rest_before;
    } else {
      const Eigen::Vector3d t = edge(rod, state.x, c.edge_before).normalized();
      const Eigen::Vector3d u = edge(rod, state.x, c.edge_after).normalized();
      curvature(0, b) = 2 * t.cross(u).norm() / (1 + t.dot(u));
    }
    curvature.col(b) /= c.voronoi;
  }
  return curvature;
}

}  // namespace tencer::der
