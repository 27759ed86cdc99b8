#include "detection/sampled.hpp"

#include <algorithm>
#include <cmath>
#include <tencer/geometry/measure.hpp>

namespace tencer::symmetry {
namespace {

// The slopes at the vertices of the parabolas through three neighbours; on an open rod the first
// and the last parabola end at its ends.
Eigen::Matrix3Xd vertex_tangents(const geometry::Polyline& curve, const geometry::ArcLength& arc) {
  const int edges = arc.edges();
  Eigen::Matrix3Xd slopes(3, edges);
  for (int e = 0; e < edges; ++e)
    slopes.col(e) =
        (curve.points.col((e + 1) % curve.vertices()) - curve.points.col(e)) / arc.edge_length(e);
  if (edges == 1) return slopes.replicate(1, 2);
  // The tangent of the parabola through the edges e and f, at the vertex where they meet.
  const auto between = [&](int e, int f) -> Eigen::Vector3d {
    const double part = arc.edge_length(f) / (arc.edge_length(e) + arc.edge_length(f));
    return part * slopes.col(e) + (1.0 - part) * slopes.col(f);
  };
  Eigen::Matrix3Xd tangents(3, curve.vertices());
  for (int i = 0; i < curve.vertices(); ++i) {
    if (curve.closed)
      tangents.col(i) = between((i + edges - 1) % edges, i);
    else if (i == 0)
      tangents.col(i) = 2.0 * slopes.col(0) - between(0, 1);
    else if (i == edges)
      tangents.col(i) = 2.0 * slopes.col(edges - 1) - between(edges - 2, edges - 1);
    else
      tangents.col(i) = between(i - 1, i);
  }
  return tangents;
}

}  // namespace

Sampled sample(const Figure& figure) {
  Sampled result{.figure = figure,
                 .diagonal = geometry::bounding_box_diagonal(figure.curves),
                 .rods = std::vector<SampledRod>(figure.curves.size())};
  const int rods = static_cast<int>(figure.curves.size());
  double total = 0.0;
  for (int r = 0; r < rods; ++r) {
    SampledRod& rod = result.rods[r];
    rod.tangents = vertex_tangents(figure.curves[r], figure.rods[r]);
    const double length = figure.rods[r].length();
    const double step = length / (figure.rods[r].closed() ? samples : samples - 1);
    rod.at.resize(samples);
    rod.points.resize(3, samples);
    for (int k = 0; k < samples; ++k) {
      rod.at[k] = std::min(k * step, length);
      rod.points.col(k) = place(result, r, rod.at[k]).point;
    }
    result.centre += length * rod.points.rowwise().mean();
    total += length;
  }
  result.centre /= total;
  for (geometry::Polyline& curve : result.figure.curves) curve.points.colwise() -= result.centre;
  result.figure.anchors.colwise() -= result.centre;
  for (SampledRod& rod : result.rods) {
    rod.points.colwise() -= result.centre;
    rod.mean = rod.points.rowwise().mean();
    rod.moment = rod.points * rod.points.transpose() / samples;
  }
  return result;
}

bool alike(const Figure& figure, int rod, int other) {
  if (rod == other) return true;
  if (!figure.classes.empty() && figure.classes[rod] != figure.classes[other]) return false;
  if (figure.rods[rod].closed() != figure.rods[other].closed()) return false;
  const double a = figure.rods[rod].length();
  const double b = figure.rods[other].length();
  return std::abs(a - b) <= 0.01 * std::max(a, b);
}

Place place(const Sampled& sampled, int rod, double s) {
  const geometry::Polyline& curve = sampled.figure.curves[rod];
  const geometry::ArcLength& arc = sampled.figure.rods[rod];
  const Eigen::Matrix3Xd& tangents = sampled.rods[rod].tangents;
  const auto [edge, t] = arc.locate(s);
  const int next = (edge + 1) % curve.vertices();
  const double length = arc.edge_length(edge);
  const Eigen::Vector3d from = curve.points.col(edge);
  const Eigen::Vector3d along = curve.points.col(next) - from;
  // How the tangents at the two ends differ from the edge.
  const Eigen::Vector3d first = length * tangents.col(edge) - along;
  const Eigen::Vector3d last = length * tangents.col(next) - along;
  const double u = 1.0 - t;
  return {from + t * along + t * u * (u * first - t * last),
          (along + u * (u - 2.0 * t) * first + t * (t - 2.0 * u) * last) / length};
}

}  // namespace tencer::symmetry
