#include "scene_targets.hpp"

#include <algorithm>
#include <tencer/geometry/measure.hpp>

#include "bad_input.hpp"
#include "text.hpp"

namespace tencer::io {
namespace {

constexpr double negligible_gap = 1e-9;  // relative to the bounding-box diagonal of all targets

std::vector<geometry::Polyline> targets(const std::vector<SceneRod>& rods) {
  std::vector<geometry::Polyline> result;
  for (const SceneRod& rod : rods) result.push_back(rod.target);
  return result;
}

std::string vertex_name(int rod, int vertex) {
  return "vertex " + std::to_string(vertex) + " of rod " + std::to_string(rod);
}

}  // namespace

void check_vertices(const std::vector<SceneRod>& rods, const std::string& where) {
  const auto curves = targets(rods);
  const auto closest = geometry::closest_vertices(curves);
  if (!closest || closest->distance > negligible_gap * geometry::bounding_box_diagonal(curves))
    return;
  const std::string first = vertex_name(closest->rod_a, closest->vertex_a);
  const std::string second = vertex_name(closest->rod_b, closest->vertex_b);
  fail(where, (closest->rod_a == closest->rod_b ? "the rod crosses itself: " : "two rods cross: ") +
                  first + " and " + second +
                  " are the same point, and a cable between them has no length; move the curves "
                  "apart there");
}

void check_plane(const Scene& scene, const std::string& where) {
  const auto curves = targets(scene.rods);
  const double z = curves[0].points(2, 0);
  const double tolerance = negligible_gap * geometry::bounding_box_diagonal(curves);
  for (int rod = 0; rod < static_cast<int>(curves.size()); ++rod)
    for (int i = 0; i < curves[rod].vertices(); ++i)
      if (std::abs(curves[rod].points(2, i) - z) > tolerance)
        fail(where, "planar: all z coordinates must be the same, but " + vertex_name(0, 0) +
                        " has z = " + to_text(z) + " and " + vertex_name(rod, i) +
                        " has z = " + to_text(curves[rod].points(2, i)));
  for (int i = 0; i < scene.anchors.cols(); ++i)
    if (std::abs(scene.anchors(2, i) - z) > tolerance)
      fail(where,
           "planar: all z coordinates must be the same, but the rods have z = " + to_text(z) +
               " and anchor " + std::to_string(i) + " has z = " + to_text(scene.anchors(2, i)));
}

double default_radius(const std::vector<SceneRod>& rods) {
  double longest = 0.0;
  for (const SceneRod& rod : rods)
    longest = std::max(longest, geometry::edge_lengths(rod.target).sum());
  return longest / 1000.0;
}

}  // namespace tencer::io
