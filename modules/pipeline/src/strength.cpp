#include "strength.hpp"

#include <sstream>
#include <tencer/core/names.hpp>
#include <tencer/model/strain.hpp>

namespace tencer::pipeline {
namespace {

// In the scene's units.
std::vector<std::optional<model::BendingStrain>> target_strains(const model::Structure& structure,
                                                                const model::State& start,
                                                                double unit) {
  auto strains = model::largest_bending_strains(structure, start);
  for (auto& strain : strains)
    if (strain) strain = model::unscaled(*strain, unit);
  return strains;
}

}  // namespace

std::optional<core::Error> check_bends(const model::Scene& scene, const model::Structure& structure,
                                       const model::State& start, double unit) {
  const auto strains = target_strains(structure, start, unit);
  for (std::size_t r = 0; r < strains.size(); ++r) {
    if (!strains[r] || strains[r]->strain < 1) continue;
    std::ostringstream text;
    text.precision(3);
    text << core::rod_in_words(r, structure.rods.size())
         << " is thicker than its bends are wide: at arc length " << strains[r]->s << ' '
         << scene.length_unit << " the curve has a radius of " << 1 / strains[r]->curvature << ' '
         << scene.length_unit
         << ", less than the rod's own; make the rod thinner, or check length_unit";
    return core::Error{scene.source, text.str()};
  }
  return std::nullopt;
}

std::vector<std::string> bend_warnings(const model::Scene& scene, const model::Structure& structure,
                                       const model::State& start, double unit) {
  std::vector<std::string> warnings;
  const auto strains = target_strains(structure, start, unit);
  for (std::size_t r = 0; r < strains.size(); ++r)
    if (auto problem =
            bend_warning(scene.structure, r, scene.target.points[r], strains[r], scene.length_unit))
      warnings.push_back(std::move(*problem));
  return warnings;
}

}  // namespace tencer::pipeline
