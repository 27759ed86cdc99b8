#include <Eigen/LU>
#include <algorithm>
#include <tencer/core/error.hpp>
#include <tencer/geometry/spline.hpp>
#include <utility>

namespace tencer::geometry {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;

// Second derivatives at the knots: slopes must agree on both sides of each.
Matrix3Xd second_derivatives(const Polyline& through, const Eigen::VectorXd& chords) {
  const int n = through.vertices();
  MatrixXd system = MatrixXd::Zero(n, n);
  Matrix3Xd right = Matrix3Xd::Zero(3, n);
  const Matrix3Xd slopes = edge_vectors(through).array().rowwise() / chords.transpose().array();
  for (int i = 0; i < n; ++i) {
    if (!through.closed && (i == 0 || i == n - 1)) {
      system(i, i) = 1;
      continue;
    }
    const int before = (i + n - 1) % n;
    const int after = (i + 1) % n;
    system(i, before) += chords[before] / 6;
    system(i, i) += (chords[before] + chords[i]) / 3;
    system(i, after) += chords[i] / 6;
    right.col(i) = slopes.col(i) - slopes.col(before);
  }
  return system.partialPivLu().solve(right.transpose()).transpose();
}

}  // namespace

Curve spline(const Polyline& through) {
  core::require(through.vertices() >= (through.closed ? 3 : 2), "spline: too few points");
  const ArcLength arc = arc_length(through);
  const Matrix3Xd bends = second_derivatives(through, edge_lengths(through));
  return [through, arc, bends](double at) -> Vector3d {
    // Periodic also where the parameter is the period itself.
    const auto [edge, t] = arc.locate(at);
    const int next = (edge + 1) % through.vertices();
    const double h = arc.edge_length(edge);
    const double u = 1 - t;
    return u * through.points.col(edge) + t * through.points.col(next) +
           h * h / 6 * ((u * u * u - u) * bends.col(edge) + (t * t * t - t) * bends.col(next));
  };
}

Polyline sample_spline(const Polyline& through, int n) {
  return sample(spline(through), 0, edge_lengths(through).sum(), n, through.closed);
}

}  // namespace tencer::geometry
