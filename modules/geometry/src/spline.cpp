#include <Eigen/SparseCholesky>
#include <algorithm>
#include <tencer/core/error.hpp>
#include <tencer/geometry/spline.hpp>
#include <vector>

namespace tencer::geometry {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Second derivatives at the knots: slopes must agree on both sides of each. At the ends of an open
// curve they are zero; all others are the unknowns of a symmetric positive definite system.
Matrix3Xd second_derivatives(const Polyline& through, const Eigen::VectorXd& chords) {
  const int n = through.vertices();
  const int ends = through.closed ? 0 : 1;
  const int unknowns = n - 2 * ends;
  Matrix3Xd result = Matrix3Xd::Zero(3, n);
  if (unknowns == 0) return result;
  const Matrix3Xd slopes = edge_vectors(through).array().rowwise() / chords.transpose().array();
  std::vector<Eigen::Triplet<double>> entries;
  Matrix3Xd right(3, unknowns);
  for (int i = 0; i < unknowns; ++i) {
    const int after = i + ends;  // the edge after the knot
    const int before = (after + n - 1) % n;
    entries.emplace_back(i, i, (chords[before] + chords[after]) / 3);
    right.col(i) = slopes.col(after) - slopes.col(before);
    const int next = (i + 1) % unknowns;
    if (through.closed || next > i)
      entries.emplace_back(std::max(i, next), std::min(i, next), chords[after] / 6);
  }
  Eigen::SparseMatrix<double> system(unknowns, unknowns);
  system.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(system);
  result.middleCols(ends, unknowns) = factor.solve(right.transpose()).transpose();
  return result;
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
