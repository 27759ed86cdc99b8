#include <cmath>
#include <numeric>
#include <tencer/core/error.hpp>
#include <tencer/symmetry/operation.hpp>

namespace tencer::symmetry {

Operation identity(int rods, int anchors) {
  Operation result{.rods = std::vector<RodMap>(rods), .anchors = std::vector<int>(anchors)};
  for (int r = 0; r < rods; ++r) result.rods[r].rod = r;
  std::iota(result.anchors.begin(), result.anchors.end(), 0);
  return result;
}

Operation compose(const Operation& second, const Operation& first,
                  std::span<const geometry::ArcLength> rods) {
  core::require(second.rods.size() == rods.size() && first.rods.size() == rods.size() &&
                    second.anchors.size() == first.anchors.size(),
                "compose: the operations act on different rods or anchors");
  Operation result{.matrix = second.matrix * first.matrix,
                   .translation = second.matrix * first.translation + second.translation,
                   .rods = {},
                   .anchors = {}};
  for (std::size_t r = 0; r < rods.size(); ++r) {
    const RodMap& inner = first.rods[r];
    const RodMap& outer = second.rods[inner.rod];
    const geometry::ArcLength& target = rods[outer.rod];
    // The rate from the lengths themselves, so that rounding does not add up over products.
    result.rods.push_back(
        {.rod = outer.rod,
         .rate = std::copysign(target.length() / rods[r].length(), outer.rate * inner.rate),
         .offset = target.wrap(outer.rate * inner.offset + outer.offset)});
  }
  for (const int anchor : first.anchors) result.anchors.push_back(second.anchors[anchor]);
  return result;
}

springs::End image(const Operation& operation, const springs::End& end,
                   std::span<const geometry::ArcLength> rods) {
  if (const auto* at_anchor = std::get_if<springs::AtAnchor>(&end)) {
    core::require(
        at_anchor->anchor >= 0 && at_anchor->anchor < static_cast<int>(operation.anchors.size()),
        "image: no such anchor");
    return springs::AtAnchor{operation.anchors[at_anchor->anchor]};
  }
  const auto& on_rod = std::get<springs::OnRod>(end);
  core::require(on_rod.rod >= 0 && on_rod.rod < static_cast<int>(operation.rods.size()),
                "image: no such rod");
  const RodMap& map = operation.rods[on_rod.rod];
  return springs::OnRod{map.rod, rods[map.rod].wrap(map.rate * on_rod.s + map.offset)};
}

springs::Cable image(const Operation& operation, const springs::Cable& cable,
                     std::span<const geometry::ArcLength> rods) {
  springs::Cable result = cable;
  result.a = image(operation, cable.a, rods);
  result.b = image(operation, cable.b, rods);
  return result;
}

}  // namespace tencer::symmetry
