#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/core/names.hpp>
#include <tencer/der/curvature.hpp>
#include <tencer/geometry/corners.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/model/scene.hpp>
#include <utility>

namespace tencer::model {
namespace {

core::Place place_of(const Scene& scene, const geometry::EdgePoint& point) {
  const Eigen::VectorXd& lengths = scene.structure.rods[point.rod].rest_lengths;
  return {.rod = point.rod, .s = lengths.head(point.edge).sum() + point.t * lengths[point.edge]};
}

// Rounded down.
double two_digits(double value) {
  constexpr double rounding = 1e-9;  // of a number that has two digits already
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return std::floor(value / digit * (1 + rounding)) * digit;
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

void add_rod(Scene& scene, const geometry::Polyline& curve, const Material& material) {
  scene.structure.rods.push_back(
      {.closed = curve.closed, .section = {}, .rest_lengths = geometry::edge_lengths(curve)});
  scene.structure.materials.push_back(material);
  scene.target.points.push_back(curve.points);
  scene.target.weights.emplace_back(Eigen::VectorXd::Ones(curve.vertices()));
  scene.directors.emplace_back();
}

std::optional<std::string> crossing(const Scene& scene) {
  constexpr double negligible_gap = 1e-9;  // relative to the bounding-box diagonal
  const auto curves = target_curves(scene);
  const auto closest = geometry::closest_approach(curves);
  if (!closest || closest->distance > negligible_gap * geometry::bounding_box_diagonal(curves))
    return std::nullopt;
  const std::size_t rods = curves.size();
  const std::string what = closest->a.rod == closest->b.rod
                               ? core::rod_in_words(closest->a.rod, rods) + " crosses itself"
                               : "two rods cross";
  return what + ": " +
         core::places_in_words({place_of(scene, closest->a), place_of(scene, closest->b)}, rods,
                               scene.length_unit) +
         " are the same point; move the curves apart there";
}

double chosen_radius(const std::vector<geometry::Polyline>& curves, const Material& material) {
  constexpr double slender = 1e-3;  // of the longest
  constexpr double left = 0.8;      // of the strain: between cables the rod bends further
  double longest = 0.0;
  double curvature = 0.0;
  for (const auto& curve : curves) {
    const der::Rod rod{.closed = curve.closed, .section = {}, .rest_lengths = edge_lengths(curve)};
    longest = std::max(longest, rod.length());
    Eigen::RowVectorXd bends =
        der::bending_curvature(rod, der::make_state(rod, curve.points)).row(0);
    for (const geometry::Corner& corner : geometry::corners(curve))
      bends[curve.closed ? corner.vertex : corner.vertex - 1] = 0;
    if (bends.size() > 0) curvature = std::max(curvature, bends.maxCoeff());
  }
  const double most = slender * longest;
  const double strain = left * material.strain_limit;
  return two_digits(curvature * most > strain ? strain / curvature : most);
}

Scene scene_of(const std::vector<geometry::Polyline>& curves, std::string name,
               std::string length_unit, std::string force_unit, const Material& material) {
  constexpr double poisson = 0.3;
  Scene scene{.name = std::move(name),
              .length_unit = std::move(length_unit),
              .force_unit = std::move(force_unit)};
  const auto section =
      der::solid_circle(youngs_modulus_in(material, scene.length_unit, scene.force_unit), poisson,
                        chosen_radius(curves, material));
  for (const auto& curve : curves) {
    add_rod(scene, curve, material);
    scene.structure.rods.back().section = section;
  }
  return scene;
}

}  // namespace tencer::model
