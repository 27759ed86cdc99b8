#include <tencer/core/error.hpp>
#include <tencer/geometry/corners.hpp>
#include <tencer/geometry/sampling.hpp>
#include <tencer/geometry/smooth.hpp>
#include <vector>

namespace tencer::geometry {
namespace {

// Points of every edge (3 x edges * pieces), from its first vertex on.
Eigen::Matrix3Xd pieces_of(const Polyline& curve, int pieces) {
  const ArcLength arc = arc_length(curve);
  Eigen::VectorXd at(curve.edges() * pieces);
  for (int e = 0; e < curve.edges(); ++e)
    for (int k = 0; k < pieces; ++k)
      at[e * pieces + k] = arc.knots()[e] + arc.edge_length(e) * k / pieces;
  return smooth_points(curve.points, arc, at);
}

// The vertices from one to a later one, counted on beyond the seam.
Polyline stretch(const Polyline& curve, int from, int to) {
  Polyline part{Eigen::Matrix3Xd(3, to - from + 1), false};
  for (int i = from; i <= to; ++i)
    part.points.col(i - from) = curve.points.col(i % curve.vertices());
  return part;
}

}  // namespace

Polyline smoothed(const Polyline& curve, int pieces) {
  core::require(pieces >= 1, "smoothed: an edge has at least one piece");
  const std::vector<Corner> sharp = corners(curve);
  const int n = curve.vertices();
  const int count = curve.edges() * pieces + (curve.closed ? 0 : 1);
  Polyline result{Eigen::Matrix3Xd(3, count), curve.closed};
  if (!curve.closed) result.points.col(count - 1) = curve.points.col(n - 1);
  if (sharp.empty()) {
    result.points.leftCols(curve.edges() * pieces) = pieces_of(curve, pieces);
    return result;
  }
  std::vector<int> ends;
  for (const Corner& corner : sharp) ends.push_back(corner.vertex);
  if (curve.closed) {
    ends.push_back(ends.front() + n);
  } else {
    ends.insert(ends.begin(), 0);
    ends.push_back(n - 1);
  }
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (ends[i] == ends[i + 1]) continue;
    const Eigen::Matrix3Xd points = pieces_of(stretch(curve, ends[i], ends[i + 1]), pieces);
    for (Eigen::Index k = 0; k < points.cols(); ++k)
      result.points.col((ends[i] * pieces + k) % (n * pieces)) = points.col(k);
  }
  return result;
}

}  // namespace tencer::geometry
