#include <algorithm>
#include <tencer/model/material.hpp>
#include <tencer/model/units.hpp>

#include "check/pose.hpp"

namespace tencer::pipeline {

model::Holds holds(const RestPose& pose, const CheckOptions& options) {
  const model::Design& design = pose.design;
  model::Holds result{
      .material = material_of(design, 0).name,
      .strain_limit = material_of(design, 0).strain_limit,
      .breaking_load = options.breaking_load_newtons / model::newtons(design.force_unit)};
  // The rod that is nearest to its limit, or furthest beyond.
  for (int r = 0; r < static_cast<int>(design.strains.size()); ++r) {
    const auto& strain = design.strains[r];
    const model::Material& material = material_of(design, r);
    if (!strain || strain->strain * result.strain_limit < result.strain * material.strain_limit)
      continue;
    result.strain = strain->strain;
    result.rod = r;
    result.s = strain->s;
    result.material = material.name;
    result.strain_limit = material.strain_limit;
  }
  for (int c = 0; c < static_cast<int>(design.built.size()); ++c)
    if (design.built[c].tension > result.tension) {
      result.tension = design.built[c].tension;
      result.cable = c;
    }
  return result;
}

}  // namespace tencer::pipeline
