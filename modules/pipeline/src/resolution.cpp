#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tencer/core/error.hpp>
#include <tencer/geometry/sampling.hpp>
#include <tencer/geometry/spline.hpp>
#include <tencer/pipeline/resolution.hpp>
#include <utility>

namespace tencer::pipeline {
namespace {

int scaled_edges(const geometry::Polyline& curve, double times) {
  return std::max(curve.closed ? 3 : 2, static_cast<int>(std::lround(curve.edges() * times)));
}

// From the vertices of a rod to those of the same rod with more or fewer.
struct VertexMap {
  int edges = 0;
  int new_edges = 0;
  bool closed = false;

  int operator()(int vertex) const {
    const double at = static_cast<double>(vertex) * new_edges / edges;
    const int nearest = static_cast<int>(std::lround(at));
    return closed ? nearest % new_edges : nearest;
  }
};

io::SceneRod resampled(const io::SceneRod& rod, double times, bool planar) {
  io::SceneRod result = rod;
  const VertexMap back{scaled_edges(rod.target, times), rod.target.edges(), rod.target.closed};
  result.target = geometry::sample_spline(rod.target, back.edges + (rod.target.closed ? 0 : 1));
  if (planar) result.target.points.row(2).setConstant(rod.target.points(2, 0));

  result.weights.resize(result.target.vertices());
  for (int i = 0; i < result.target.vertices(); ++i) result.weights[i] = rod.weights[back(i)];

  const geometry::ArcLength arc = geometry::arc_length(rod.target);
  const double stretch = geometry::edge_lengths(result.target).sum() / arc.length();
  for (int vertex : rod.forbidden_vertices)
    result.forbidden_arcs.push_back({arc.knots()[vertex], arc.knots()[vertex]});
  result.forbidden_vertices.clear();
  for (io::Arc& forbidden : result.forbidden_arcs) {
    forbidden.from *= stretch;
    forbidden.to *= stretch;
  }
  return result;
}

using Axes = std::array<bool, 3>;

// The pinned axes of each vertex of each rod: (rod, vertex).
std::map<std::pair<int, int>, Axes> pinned_axes(const std::vector<io::Pin>& pins) {
  std::map<std::pair<int, int>, Axes> result;
  for (const io::Pin& pin : pins)
    for (std::size_t axis = 0; axis < 3; ++axis)
      result[{pin.rod, pin.vertex}][axis] |= pin.axes[axis];
  return result;
}

std::vector<io::Pin> moved_pins(const io::Scene& scene, double times) {
  const auto pinned = pinned_axes(scene.pinned);
  std::map<std::pair<int, int>, Axes> moved;
  const auto add = [&](int rod, int vertex, const Axes& axes) {
    for (std::size_t axis = 0; axis < 3; ++axis) moved[{rod, vertex}][axis] |= axes[axis];
  };
  for (const auto& [place, axes] : pinned) {
    const auto& [rod, vertex] = place;
    const geometry::Polyline& curve = scene.rods[rod].target;
    const int new_edges = scaled_edges(curve, times);
    const VertexMap to{curve.edges(), new_edges, curve.closed};
    add(rod, to(vertex), axes);
    const auto next = pinned.find({rod, (vertex + 1) % curve.vertices()});
    if (next == pinned.end() || vertex >= curve.edges()) continue;
    Axes both{};
    for (std::size_t axis = 0; axis < 3; ++axis) both[axis] = axes[axis] && next->second[axis];
    if (both == Axes{}) continue;
    const int vertices = curve.closed ? new_edges : new_edges + 1;
    for (int v = to(vertex); v != to(next->first.second); v = (v + 1) % vertices) add(rod, v, both);
  }
  std::vector<io::Pin> pins;
  for (const auto& [place, axes] : moved)
    pins.push_back({.rod = place.first, .vertex = place.second, .axes = axes});
  return pins;
}

}  // namespace

io::Scene at_resolution(const io::Scene& scene, double times) {
  core::require(times > 0 && std::isfinite(times), "at_resolution: needs a positive factor");
  if (times == 1) return scene;
  io::Scene result = scene;
  for (io::SceneRod& rod : result.rods) rod = resampled(rod, times, scene.planar);
  result.pinned = moved_pins(scene, times);
  for (io::PointLoad& load : result.point_loads)
    load.s *= geometry::edge_lengths(result.rods[load.rod].target).sum() /
              geometry::edge_lengths(scene.rods[load.rod].target).sum();
  return result;
}

}  // namespace tencer::pipeline
