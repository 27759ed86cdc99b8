#include <Eigen/Dense>
#include <algorithm>
#include <optional>
#include <tencer/fabricate/crossings.hpp>
#include <tuple>

namespace tencer::fabricate {
namespace {

using Eigen::Vector3d;

struct SeenEdge {
  geometry::EdgePoint at{};  // t unused
  Vector3d from = Vector3d::Zero();
  Vector3d along = Vector3d::Zero();

  double least_x() const { return from.x() + std::min(0.0, along.x()); }
  double most_x() const { return from.x() + std::max(0.0, along.x()); }
  double least_y() const { return from.y() + std::min(0.0, along.y()); }
  double most_y() const { return from.y() + std::max(0.0, along.y()); }
};

std::vector<SeenEdge> seen(std::span<const geometry::Polyline> curves,
                           const Eigen::Matrix3d& view) {
  std::vector<SeenEdge> edges;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const geometry::Polyline& curve = curves[c];
    const Eigen::Matrix3Xd points = view * curve.points;
    for (int e = 0; e < curve.edges(); ++e) {
      const Vector3d from = points.col(e);
      edges.push_back({.at = {static_cast<int>(c), e, 0.0},
                       .from = from,
                       .along = points.col((e + 1) % curve.vertices()) - from});
    }
  }
  return edges;
}

double cross(const Vector3d& a, const Vector3d& b) { return a.x() * b.y() - a.y() * b.x(); }

bool share_vertex(const SeenEdge& a, const SeenEdge& b,
                  std::span<const geometry::Polyline> curves) {
  if (a.at.rod != b.at.rod) return false;
  const int apart = std::abs(a.at.edge - b.at.edge);
  const geometry::Polyline& curve = curves[a.at.rod];
  return apart <= 1 || (curve.closed && apart == curve.edges() - 1);
}

std::optional<Crossing> crossing(const SeenEdge& a, const SeenEdge& b) {
  const double area = cross(a.along, b.along);
  if (area == 0) return std::nullopt;
  const Vector3d between = b.from - a.from;
  const double t_a = cross(between, b.along) / area;
  const double t_b = cross(between, a.along) / area;
  if (t_a < 0 || t_a >= 1 || t_b < 0 || t_b >= 1) return std::nullopt;
  const double above = (a.from + t_a * a.along).z() - (b.from + t_b * b.along).z();
  Crossing found{.over = {a.at.rod, a.at.edge, t_a},
                 .under = {b.at.rod, b.at.edge, t_b},
                 .sine = area / (a.along.head<2>().norm() * b.along.head<2>().norm()),
                 .height = std::abs(above)};
  if (above < 0) {
    std::swap(found.over, found.under);
    found.sine = -found.sine;
  }
  return found;
}

}  // namespace

std::vector<Crossing> crossings(std::span<const geometry::Polyline> curves,
                                const Eigen::Matrix3d& view) {
  std::vector<SeenEdge> edges = seen(curves, view);
  std::ranges::stable_sort(edges, {}, &SeenEdge::least_x);
  std::vector<Crossing> found;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const SeenEdge& a = edges[i];
    for (std::size_t j = i + 1; j < edges.size() && edges[j].least_x() <= a.most_x(); ++j) {
      const SeenEdge& b = edges[j];
      if (b.least_y() > a.most_y() || a.least_y() > b.most_y() || share_vertex(a, b, curves))
        continue;
      if (const auto one = crossing(a, b)) found.push_back(*one);
    }
  }
  std::ranges::sort(found, {}, [](const Crossing& c) {
    return std::tuple(c.under.rod, c.under.edge, c.under.t, c.over.rod, c.over.edge);
  });
  return found;
}

}  // namespace tencer::fabricate
