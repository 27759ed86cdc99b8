#include <tencer/symmetry/orbit.hpp>

#include "cables/cable_index.hpp"
#include "cables/own_symmetry.hpp"

namespace tencer::symmetry {

std::vector<springs::Cable> orbit(const springs::Cable& cable, const Group& group,
                                  double tolerance) {
  return complete(std::span(&cable, 1), group, tolerance);
}

std::vector<springs::Cable> complete(std::span<const springs::Cable> cables, const Group& group,
                                     double tolerance) {
  for (const springs::Cable& cable : cables) validate(cable, group);
  struct Range {
    std::size_t begin, end;  // in `result`
    int given;
  };
  std::vector<Range> orbits;
  std::vector<springs::Cable> result;
  CableIndex index(group.rods, tolerance);
  for (const springs::Cable& cable : cables) {
    if (const auto known = index.find(cable)) {
      Range& range = orbits[known->value];
      ++range.given;
      result[range.begin].stiffness += cable.stiffness;
      result[range.begin].rest_length += cable.rest_length;
      continue;
    }
    const springs::Cable first = own_symmetry(cable, group, tolerance).cable;
    const std::size_t begin = result.size();
    CableIndex members(group.rods, tolerance);
    for (const Operation& operation : group.operations) {
      const springs::Cable member = image(operation, first, group.rods);
      if (members.find(member)) continue;
      members.add(member, 0);
      index.add(member, static_cast<int>(orbits.size()));
      result.push_back(member);
    }
    orbits.push_back({begin, result.size(), 1});
  }
  for (const Range& range : orbits) {
    const springs::Cable& first = result[range.begin];
    const double stiffness = first.stiffness / range.given;
    const double rest_length = first.rest_length / range.given;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      result[i].stiffness = stiffness;
      result[i].rest_length = rest_length;
    }
  }
  return result;
}

}  // namespace tencer::symmetry
