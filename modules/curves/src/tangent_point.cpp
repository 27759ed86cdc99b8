#include "tangent_point.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <tencer/core/error.hpp>

namespace tencer::curves {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using geometry::Polyline;

TangentPoint tangent_point_energy(const Polyline& curve) {
  core::require(curve.closed && curve.vertices() >= 3,
                "tangent_point_energy: needs a closed curve");
  const int n = curve.vertices();
  const Matrix3Xd edges = geometry::edge_vectors(curve);
  const Eigen::VectorXd lengths = edges.colwise().norm().transpose();
  const Matrix3Xd midpoints = curve.points + edges / 2;

  double sum = 0;
  Matrix3Xd by_edge = Matrix3Xd::Zero(3, n);
  Matrix3Xd by_midpoint = Matrix3Xd::Zero(3, n);
  Eigen::VectorXd by_length = Eigen::VectorXd::Zero(n);
  for (int i = 0; i < n; ++i) {
    const Vector3d edge = edges.col(i);
    for (int j = 0; j < n; ++j) {
      if (i == j) continue;
      // term = |edge x d|^3 l_i^-2 l_j |d|^-6
      const Vector3d d = midpoints.col(i) - midpoints.col(j);
      const Vector3d across = edge.cross(d);
      const double squared = d.squaredNorm();
      const double factor =
          across.norm() * lengths[j] / (lengths[i] * lengths[i] * squared * squared * squared);
      const double term = across.squaredNorm() * factor;
      sum += term;
      const Vector3d by_across = 3 * factor * across;
      const Vector3d by_d = by_across.cross(edge) - 6 * term / squared * d;
      by_edge.col(i) += d.cross(by_across);
      by_midpoint.col(i) += by_d;
      by_midpoint.col(j) -= by_d;
      by_length[i] -= 2 * term / lengths[i];
      by_length[j] += term / lengths[j];
    }
  }
  const double total = lengths.sum();
  TangentPoint result{total * sum, Matrix3Xd::Zero(3, n)};
  for (int i = 0; i < n; ++i) {
    const Vector3d along =
        total * by_edge.col(i) + (total * by_length[i] + sum) / lengths[i] * edges.col(i);
    result.gradient.col(i) += total * by_midpoint.col(i) / 2 - along;
    result.gradient.col((i + 1) % n) += total * by_midpoint.col(i) / 2 + along;
  }
  return result;
}

}  // namespace tencer::curves
