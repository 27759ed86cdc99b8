#include <tencer/geometry/polyline.hpp>

namespace tencer::geometry {

Eigen::Matrix3Xd edge_vectors(const Polyline& curve) {
  const int n = curve.vertices();
  Eigen::Matrix3Xd edges(3, curve.edges());
  for (int i = 0; i < curve.edges(); ++i)
    edges.col(i) = curve.points.col((i + 1) % n) - curve.points.col(i);
  return edges;
}

Eigen::VectorXd edge_lengths(const Polyline& curve) {
  return edge_vectors(curve).colwise().norm().transpose();
}

}  // namespace tencer::geometry
