#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tencer/core/error.hpp>
#include <tencer/core/names.hpp>
#include <tencer/core/words.hpp>
#include <tencer/geometry/corners.hpp>
#include <tencer/geometry/sampling.hpp>
#include <tencer/geometry/spline.hpp>
#include <tencer/model/resolution.hpp>
#include <tencer/model/rest_shape.hpp>
#include <utility>

namespace tencer::model {
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

// Gives rod r of `scene` the vertices of `result`: its target, weights, shape at rest and length.
void resample(const Scene& scene, int r, double times, Scene& result) {
  const geometry::Polyline curve = target_curve(scene, r);
  const VertexMap back{scaled_edges(curve, times), curve.edges(), curve.closed};
  geometry::Polyline fine = geometry::sample_spline(curve, back.edges + (curve.closed ? 0 : 1));
  if (scene.structure.planar) fine.points.row(2).setConstant(curve.points(2, 0));
  Eigen::VectorXd& weights = result.target.weights[r];
  weights.resize(fine.vertices());
  for (int i = 0; i < fine.vertices(); ++i) weights[i] = scene.target.weights[r][back(i)];
  der::Rod& rod = result.structure.rods[r];
  rod.rest_lengths = geometry::edge_lengths(fine);
  copy_rest_shape(scene.structure.rods[r], rod);
  result.target.points[r] = std::move(fine.points);
}

using Axes = std::array<bool, 3>;

// The pinned axes of each vertex of each rod: (rod, vertex).
std::map<std::pair<int, int>, Axes> pinned_axes(const std::vector<Pin>& pins) {
  std::map<std::pair<int, int>, Axes> result;
  for (const Pin& pin : pins)
    for (std::size_t axis = 0; axis < 3; ++axis)
      result[{pin.rod, pin.vertex}][axis] |= pin.axes[axis];
  return result;
}

std::vector<Pin> moved_pins(const Scene& scene, const std::vector<double>& times) {
  const auto pinned = pinned_axes(scene.structure.pins);
  std::map<std::pair<int, int>, Axes> moved;
  const auto add = [&](int rod, int vertex, const Axes& axes) {
    for (std::size_t axis = 0; axis < 3; ++axis) moved[{rod, vertex}][axis] |= axes[axis];
  };
  for (const auto& [place, axes] : pinned) {
    const auto& [rod, vertex] = place;
    const geometry::Polyline curve = target_curve(scene, rod);
    const int new_edges = scaled_edges(curve, times[rod]);
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
  std::vector<Pin> pins;
  for (const auto& [place, axes] : moved)
    pins.push_back({.rod = place.first, .vertex = place.second, .axes = axes});
  return pins;
}

// What of a curve's vertices its bends need: each turns little, which follows the curve to a few
// millionths of its size.
int enough_vertices(const geometry::Polyline& curve) {
  constexpr int enough = 1000;
  constexpr double slight_turn = 0.03;  // radians
  return std::max(enough,
                  static_cast<int>(std::ceil(geometry::total_turning(curve) / slight_turn)));
}

}  // namespace

Scene at_resolution(const Scene& scene, double times) {
  core::require(times > 0 && std::isfinite(times), "at_resolution: needs a positive factor");
  return at_resolution(scene, std::vector<double>(scene.structure.rods.size(), times));
}

Scene at_resolution(const Scene& scene, const std::vector<double>& times) {
  core::require(times.size() == scene.structure.rods.size(),
                "at_resolution: needs a factor for each rod");
  Scene result = scene;
  std::vector<double> stretch;
  for (int r = 0; r < static_cast<int>(times.size()); ++r) {
    core::require(times[r] > 0 && std::isfinite(times[r]), "at_resolution: needs positive factors");
    if (times[r] != 1) resample(scene, r, times[r], result);
    stretch.push_back(result.structure.rods[r].length() / scene.structure.rods[r].length());
  }
  result.structure.pins = moved_pins(scene, times);
  for (PointLoad& load : result.structure.point_loads) load.s *= stretch[load.rod];
  for (Arc& arc : result.rules.forbidden) {
    arc.from *= stretch[arc.rod];
    arc.to *= stretch[arc.rod];
  }
  return result;
}

Scene with_enough_vertices(const Scene& scene) {
  constexpr double worthwhile = 0.5;
  std::vector<double> times;
  std::string note;
  for (std::size_t r = 0; r < scene.structure.rods.size(); ++r) {
    const geometry::Polyline curve = target_curve(scene, r);
    const double part = static_cast<double>(enough_vertices(curve)) / curve.vertices();
    times.push_back(part < worthwhile ? part : 1.0);
    if (part < worthwhile)
      note += (note.empty() ? "" : ", ") + core::rod_in_words(r, scene.structure.rods.size()) +
              " with " + core::counted(scaled_edges(curve, part), "edge") + " in place of " +
              std::to_string(curve.edges());
  }
  if (note.empty()) return scene;
  Scene result = at_resolution(scene, times);
  result.notes.push_back(
      "more vertices than the bends need, so it is designed with fewer along the "
      "same curve: " +
      note);
  return result;
}

}  // namespace tencer::model
