#include <algorithm>
#include <array>
#include <cmath>
#include <tencer/ground_structure/candidate_columns.hpp>
#include <tencer/springs/law.hpp>
#include <tencer/symmetry/orbit.hpp>
#include <utility>

namespace tencer::ground_structure {
namespace {

// Where a cable ends, ordered: the same for a cable and its reversal. For each end the rod and the
// part of its length, or minus a number for an anchor.
using Places = std::array<double, 4>;

Places places_of(const springs::Cable& cable, const equilibrium::System& system) {
  const auto place = [&](const springs::End& end) -> std::array<double, 2> {
    if (const auto* anchor = std::get_if<springs::AtAnchor>(&end))
      return {-1.0 - anchor->anchor, 0.0};
    const auto& on = std::get<springs::OnRod>(end);
    const geometry::ArcLength& rod = system.arc_lengths()[on.rod];
    const double part = rod.wrap(on.s) / rod.length();
    // Just below the seam is at it.
    const bool seam = rod.closed() && 1 - part < symmetry::same_place;
    return {static_cast<double>(on.rod), seam ? 0.0 : part};
  };
  auto a = place(cable.a);
  auto b = place(cable.b);
  if (b < a) std::swap(a, b);
  return {a[0], a[1], b[0], b[1]};
}

// Whether the first of two is clearly before the second.
bool clearly_before(const Places& a, const Places& b) {
  for (std::size_t i = 0; i < 4; ++i)
    if (std::abs(a[i] - b[i]) > symmetry::same_place) return a[i] < b[i];
  return false;
}

CandidateColumn column_of(const springs::Cable& cable, const equilibrium::System& system,
                          const model::State& state) {
  CandidateColumn column{
      .cable = cable,
      .stencil = springs::stencil(cable, system.arc_lengths(), system.structure().anchors)};
  const Eigen::Vector3d span = model::span_of(column.stencil, state);
  column.length = span.norm();
  column.direction = span / column.length;
  return column;
}

}  // namespace

std::vector<CandidateOrbit> candidate_orbits(const equilibrium::System& system,
                                             const model::State& state,
                                             std::span<const springs::Cable> candidates,
                                             const symmetry::Group* symmetry) {
  std::vector<CandidateOrbit> orbits;
  for (const auto& cable : candidates) {
    if (!symmetry) {
      orbits.push_back({column_of(cable, system, state)});
      continue;
    }
    const Places own = places_of(cable, system);
    const auto images = symmetry::orbit(cable, *symmetry);
    const bool first = std::ranges::none_of(
        images, [&](const auto& image) { return clearly_before(places_of(image, system), own); });
    if (!first) continue;
    CandidateOrbit& orbit = orbits.emplace_back();
    for (const auto& image : images) orbit.push_back(column_of(image, system, state));
  }
  return orbits;
}

std::vector<springs::Cable> cables_of(const CandidateOrbit& orbit, double tension,
                                      double rest_ratio) {
  std::vector<springs::Cable> cables;
  for (const CandidateColumn& column : orbit)
    cables.push_back(springs::with_tension(column.cable, column.length, tension, rest_ratio));
  return cables;
}

}  // namespace tencer::ground_structure
