#include "design_in_units.hpp"

#include <algorithm>
#include <tencer/io/design.hpp>
#include <tencer/model/units.hpp>

namespace tencer::app {

core::Expected<model::Design> read_design_in_units(const std::filesystem::path& path) {
  auto design = io::read_design(path);
  if (!design) return design;
  if (std::ranges::count(model::length_units(), design->length_unit) == 0 ||
      std::ranges::count(model::force_units(), design->force_unit) == 0)
    return core::Error{path.string(),
                       "its units, " + design->length_unit + " and " + design->force_unit +
                           ", are not known; lengths can be in mm, cm or m, forces in mN, N or kN"};
  return design;
}

}  // namespace tencer::app
