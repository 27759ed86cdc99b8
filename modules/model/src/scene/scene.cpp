#include <algorithm>
#include <tencer/core/error.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/model/scene.hpp>
#include <tencer/model/units.hpp>
#include <utility>

namespace tencer::model {
namespace {

std::string vertex_name(int rod, int vertex) {
  return "vertex " + std::to_string(vertex) + " of rod " + std::to_string(rod);
}

}  // namespace

geometry::Polyline target_curve(const Scene& scene, std::size_t rod) {
  return {scene.target.points[rod], scene.structure.rods[rod].closed};
}

std::vector<geometry::Polyline> target_curves(const Scene& scene) {
  std::vector<geometry::Polyline> curves;
  for (std::size_t r = 0; r < scene.structure.rods.size(); ++r)
    curves.push_back(target_curve(scene, r));
  return curves;
}

void add_rod(Scene& scene, const geometry::Polyline& curve) {
  scene.structure.rods.push_back(
      {.closed = curve.closed, .section = {}, .rest_lengths = geometry::edge_lengths(curve)});
  scene.target.points.push_back(curve.points);
  scene.target.weights.emplace_back(Eigen::VectorXd::Ones(curve.vertices()));
  scene.directors.emplace_back();
}

std::optional<std::string> touching_vertices(const Scene& scene) {
  constexpr double negligible_gap = 1e-9;  // relative to the bounding-box diagonal
  const auto curves = target_curves(scene);
  const auto closest = geometry::closest_vertices(curves);
  if (!closest || closest->distance > negligible_gap * geometry::bounding_box_diagonal(curves))
    return std::nullopt;
  return (closest->rod_a == closest->rod_b ? "the rod crosses itself: " : "two rods cross: ") +
         vertex_name(closest->rod_a, closest->vertex_a) + " and " +
         vertex_name(closest->rod_b, closest->vertex_b) +
         " are the same point, and a cable between them has no length; move the curves apart there";
}

double default_radius(const std::vector<geometry::Polyline>& curves) {
  double longest = 0.0;
  for (const auto& curve : curves) longest = std::max(longest, geometry::edge_lengths(curve).sum());
  return longest / 1000.0;
}

double glass_fibre_modulus(const std::string& length_unit, const std::string& force_unit) {
  const double length = metres(length_unit);
  return 40e9 / newtons(force_unit) * (length * length);
}

Scene scene_of(const std::vector<geometry::Polyline>& curves, std::string name,
               std::string length_unit, std::string force_unit) {
  constexpr double poisson = 0.3;
  Scene scene{.name = std::move(name),
              .length_unit = std::move(length_unit),
              .force_unit = std::move(force_unit)};
  const auto section = der::solid_circle(glass_fibre_modulus(scene.length_unit, scene.force_unit),
                                         poisson, default_radius(curves));
  for (const auto& curve : curves) {
    add_rod(scene, curve);
    scene.structure.rods.back().section = section;
  }
  return scene;
}

}  // namespace tencer::model
