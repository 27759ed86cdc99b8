#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <tencer/geometry/measure.hpp>
#include <vector>

namespace tencer::geometry {
namespace {

// Parameter of the point of the segment p0 p1 that is closest to the point x.
double project(const Eigen::Vector3d& x, const Eigen::Vector3d& p0, const Eigen::Vector3d& p1) {
  const Eigen::Vector3d d = p1 - p0;
  const double squared = d.squaredNorm();
  return squared > 0.0 ? std::clamp((x - p0).dot(d) / squared, 0.0, 1.0) : 0.0;
}

bool share_a_vertex(const Polyline& curve, int edge_a, int edge_b) {
  const int apart = std::abs(edge_a - edge_b);
  return apart <= 1 || (curve.closed && apart == curve.edges() - 1);
}

struct Edge {
  int rod;
  int edge;
  Eigen::Vector3d from, to, middle;
  double half;
};

std::vector<Edge> all_edges(std::span<const Polyline> curves) {
  std::vector<Edge> edges;
  for (int rod = 0; rod < static_cast<int>(curves.size()); ++rod) {
    const Polyline& curve = curves[rod];
    for (int i = 0; i < curve.edges(); ++i) {
      const Eigen::Vector3d from = curve.points.col(i);
      const Eigen::Vector3d to = curve.points.col((i + 1) % curve.vertices());
      edges.push_back({rod, i, from, to, (from + to) / 2.0, (to - from).norm() / 2.0});
    }
  }
  return edges;
}

}  // namespace

double bounding_box_diagonal(std::span<const Polyline> curves) {
  Eigen::AlignedBox3d box;
  for (const Polyline& curve : curves)
    for (int i = 0; i < curve.vertices(); ++i) box.extend(curve.points.col(i));
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

SegmentApproach segment_approach(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1,
                                 const Eigen::Vector3d& b0, const Eigen::Vector3d& b1) {
  SegmentApproach best{std::numeric_limits<double>::infinity(), 0.0, 0.0};
  const auto consider = [&](double t_a, double t_b) {
    const double distance = (((1.0 - t_a) * a0 + t_a * a1) - ((1.0 - t_b) * b0 + t_b * b1)).norm();
    if (distance < best.distance) best = {distance, t_a, t_b};
  };
  // The distance is convex in the parameters: its minimum is inside the square or on one of its
  // four sides, where one point is a segment's end. No case for parallel segments is needed.
  consider(project(b0, a0, a1), 0.0);
  consider(project(b1, a0, a1), 1.0);
  consider(0.0, project(a0, b0, b1));
  consider(1.0, project(a1, b0, b1));
  const Eigen::Vector3d a = a1 - a0;
  const Eigen::Vector3d b = b1 - b0;
  const Eigen::Vector3d normal = a.cross(b);
  const double squared = normal.squaredNorm();
  if (squared > 0.0) {
    const Eigen::Vector3d r = b0 - a0;
    const double t_a = r.cross(b).dot(normal) / squared;
    const double t_b = r.cross(a).dot(normal) / squared;
    if (t_a > 0.0 && t_a < 1.0 && t_b > 0.0 && t_b < 1.0) consider(t_a, t_b);
  }
  return best;
}

std::optional<Approach> closest_approach(std::span<const Polyline> curves) {
  const std::vector<Edge> edges = all_edges(curves);
  std::optional<Approach> best;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Edge& a = edges[i];
      const Edge& b = edges[j];
      if (a.rod == b.rod && share_a_vertex(curves[a.rod], a.edge, b.edge)) continue;
      // The spheres around the two edges are already too far apart.
      if (best && (a.middle - b.middle).norm() - a.half - b.half >= best->distance) continue;
      const SegmentApproach found = segment_approach(a.from, a.to, b.from, b.to);
      if (!best || found.distance < best->distance)
        best = {{a.rod, a.edge, found.t_a}, {b.rod, b.edge, found.t_b}, found.distance};
    }
  }
  return best;
}

}  // namespace tencer::geometry
