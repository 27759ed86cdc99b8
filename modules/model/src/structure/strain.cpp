#include <algorithm>
#include <numbers>
#include <sstream>
#include <tencer/core/names.hpp>
#include <tencer/der/curvature.hpp>
#include <tencer/geometry/corners.hpp>
#include <tencer/model/strain.hpp>

namespace tencer::model {
namespace {

std::optional<BendingStrain> largest(const der::Rod& rod, const der::RodState& state) {
  if (!der::half_sizes(rod.section.shape)) return std::nullopt;
  const Eigen::Matrix2Xd curvature = der::bending_curvature(rod, state);
  BendingStrain worst;
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const double strain = *der::bending_strain(rod.section.shape, curvature(0, b), curvature(1, b));
    if (strain > worst.strain)
      worst = {
          .strain = strain, .curvature = curvature.col(b).norm(), .vertex = rod.bending_vertex(b)};
  }
  worst.s = rod.rest_lengths.head(worst.vertex).sum();
  return worst;
}

// The radius to which a rod can be bent for long, as ", where glass fibre ... bends to at the
// least"; nothing when it is not known.
std::string least_radius_in_words(const Structure& structure, std::size_t rod,
                                  std::string_view length_unit) {
  const auto half = der::half_sizes(structure.rods[rod].section.shape);
  if (!half || structure.materials.empty()) return {};
  const Material& material = structure.materials[rod];
  std::ostringstream text;
  text.precision(3);
  text << " (this one, of " << material.name << ", bends to a radius of "
       << std::min(half->along_m1, half->along_m2) / material.strain_limit << ' ' << length_unit
       << " at the least)";
  return text.str();
}

std::optional<std::string> corner_problem(const Structure& structure, std::size_t rod,
                                          const Eigen::Matrix3Xd& target,
                                          std::string_view length_unit) {
  const auto corners = geometry::corners({target, structure.rods[rod].closed});
  if (corners.empty()) return std::nullopt;
  const geometry::Corner& first = corners.front();
  const auto point = target.col(first.vertex);
  std::ostringstream text;
  text.precision(3);
  text << core::rod_in_words(rod, structure.rods.size()) << " has a corner at arc length "
       << first.s << ' ' << length_unit << ", (" << point[0] << ", " << point[1] << ", " << point[2]
       << "), where it turns by " << first.angle * 180 / std::numbers::pi
       << " degrees from one edge to the next";
  if (corners.size() > 1) text << ", and " << corners.size() - 1 << " more";
  text << ": no rod follows it" << least_radius_in_words(structure, rod, length_unit)
       << "; round it with smooth = RADIUS in [[rod]], or --smooth RADIUS, or give the curve more "
          "vertices";
  return text.str();
}

// The strain beside what the material holds, and the section that holds for long.
std::string strain_in_words(const Structure& structure, std::size_t rod,
                            const BendingStrain& largest, std::string_view length_unit) {
  const Material& material = structure.materials[rod];
  const bool breaks = largest.strain > material.breaking_strain;
  const double share = material.strain_limit / largest.strain;
  std::ostringstream text;
  text.precision(3);
  text << core::rod_in_words(rod, structure.rods.size()) << " is bent to a strain of "
       << 100 * largest.strain << " % at arc length " << largest.s << ' ' << length_unit
       << ", where " << material.name << (breaks ? " breaks at " : " holds for long ")
       << 100 * (breaks ? material.breaking_strain : material.strain_limit) << " %; ";
  if (const auto* circle = std::get_if<der::Circle>(&structure.rods[rod].section.shape))
    text << "a radius of " << circle->radius * share << ' ' << length_unit << " would do";
  else
    text << "a section " << share << " times as thick would do";
  return text.str();
}

// What keeps it from being a rod at all, whatever the rod is.
std::optional<std::string> shape_problem(const Structure& structure, std::size_t rod,
                                         const Eigen::Matrix3Xd& target,
                                         std::string_view length_unit) {
  if (structure.rods[rod].rest_curvature.size() > 0) return std::nullopt;
  const geometry::Polyline curve{target, structure.rods[rod].closed};
  if (geometry::is_rough(curve)) {
    std::ostringstream text;
    text.precision(3);
    text
        << core::rod_in_words(rod, structure.rods.size())
        << " has a rough target: its curvature changes from one vertex to the next by more than it "
           "is large, most at arc length "
        << geometry::roughest(curve).s << ' ' << length_unit
        << ", which no rod follows; smooth the curve";
    return text.str();
  }
  return corner_problem(structure, rod, target, length_unit);
}

}  // namespace

std::vector<std::optional<BendingStrain>> largest_bending_strains(const Structure& structure,
                                                                  const State& state) {
  std::vector<std::optional<BendingStrain>> result;
  for (std::size_t r = 0; r < structure.rods.size(); ++r)
    result.push_back(largest(structure.rods[r], state[r]));
  return result;
}

BendingStrain unscaled(BendingStrain scaled, double unit) {
  scaled.s *= unit;
  scaled.curvature /= unit;
  return scaled;
}

std::optional<std::string> bend_problem(const Structure& structure, std::size_t rod,
                                        const Eigen::Matrix3Xd& target,
                                        const std::optional<BendingStrain>& largest,
                                        std::string_view length_unit) {
  if (auto problem = shape_problem(structure, rod, target, length_unit)) return problem;
  if (!largest || structure.materials.empty() ||
      largest->strain <= structure.materials[rod].breaking_strain)
    return std::nullopt;
  return strain_in_words(structure, rod, *largest, length_unit);
}

std::optional<std::string> bend_warning(const Structure& structure, std::size_t rod,
                                        const Eigen::Matrix3Xd& target,
                                        const std::optional<BendingStrain>& largest,
                                        std::string_view length_unit) {
  constexpr double rounding = 1e-3;  // of a strain that a chosen radius takes to the limit
  if (auto problem = shape_problem(structure, rod, target, length_unit)) return problem;
  if (!largest || structure.materials.empty() ||
      largest->strain <= structure.materials[rod].strain_limit * (1 + rounding))
    return std::nullopt;
  return strain_in_words(structure, rod, *largest, length_unit);
}

}  // namespace tencer::model
