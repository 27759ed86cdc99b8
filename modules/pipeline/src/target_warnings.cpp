#include "target_warnings.hpp"

#include <sstream>
#include <tencer/certify/closest.hpp>
#include <tencer/core/names.hpp>
#include <tencer/model/clearance.hpp>

#include "strength.hpp"

namespace tencer::pipeline {
namespace {

std::string touching(const certify::RodsApart& apart, std::size_t rods, double needed, double unit,
                     const std::string& length_unit) {
  std::ostringstream text;
  text.precision(3);
  if (apart.rod_a == apart.rod_b)
    text << core::rod_in_words(apart.rod_a, rods) << " goes through itself: ";
  else
    text << core::rods_in_words({apart.rod_a, apart.rod_b}, rods) << " go through each other: ";
  text << core::places_in_words({{apart.rod_a, apart.s_a * unit}, {apart.rod_b, apart.s_b * unit}},
                                rods, length_unit)
       << " are ";
  text << (needed + apart.distance) * unit << ' ' << length_unit
       << " apart, axis to axis, where as thick as they are they need " << needed * unit << ' '
       << length_unit << "; move the curves apart there, or make the rods thinner";
  return text.str();
}

}  // namespace

std::vector<std::string> target_warnings(const model::Scene& scene,
                                         const model::Structure& structure,
                                         const model::State& start, double unit) {
  std::vector<std::string> warnings = bend_warnings(scene, structure, start, unit);
  const auto radii = model::outer_radii(structure);
  for (const certify::RodsApart& apart : certify::closest_rods(structure, start))
    if (apart.distance < 0)
      warnings.push_back(touching(apart, radii.size(), radii[apart.rod_a] + radii[apart.rod_b],
                                  unit, scene.length_unit));
  return warnings;
}

}  // namespace tencer::pipeline
