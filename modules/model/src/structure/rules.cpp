#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/model/rules.hpp>
#include <tencer/springs/alike.hpp>

namespace tencer::model {
namespace {

geometry::ArcLength arc_length_of(const Structure& structure, int rod) {
  return {structure.rods[rod].rest_lengths, structure.rods[rod].closed};
}

// An arc as the interval that starts in [0, L); it may reach beyond L on a closed rod.
Interval unrolled(const Arc& arc, const geometry::ArcLength& along) {
  if (!along.closed()) return {arc.from, arc.to};
  const double from = along.wrap(arc.from);
  double span = arc.to - arc.from;
  if (span < 0) span += along.length();
  return {from, from + span};
}

}  // namespace

void Gaps::validate() const {
  core::require(clearance.value_or(0.0) >= 0, "Gaps::clearance must not be negative");
  core::require(mark_distance.value_or(0.0) >= 0, "Gaps::mark_distance must not be negative");
  core::require(own_radii >= 0, "Gaps::own_radii must not be negative");
}

void validate(const Rules& rules, const Structure& structure) {
  const int rods = static_cast<int>(structure.rods.size());
  const auto exists = [&](int rod) { return rod >= 0 && rod < rods; };
  if (rules.pairs)
    for (const auto& pair : *rules.pairs)
      core::require(exists(pair.a) && exists(pair.b), "Rules::pairs: no such rod");
  for (const auto& arc : rules.forbidden) {
    core::require(exists(arc.rod), "Rules::forbidden: no such rod");
    core::require(std::isfinite(arc.from) && std::isfinite(arc.to),
                  "Rules::forbidden: from and to must be finite");
    core::require(structure.rods[arc.rod].closed || arc.from <= arc.to,
                  "Rules::forbidden: from must not exceed to on an open rod");
    core::require(std::abs(arc.to - arc.from) <= structure.rods[arc.rod].length(),
                  "Rules::forbidden: longer than the rod");
  }
  core::require(rules.max_cable_length > 0, "Rules::max_cable_length must be positive");
  if (rules.gaps) rules.gaps->validate();
}

bool pair_allowed(const Rules& rules, int rod_a, int rod_b) {
  if (!rules.pairs) return true;
  return std::ranges::any_of(*rules.pairs, [&](const RodPair& pair) {
    return (pair.a == rod_a && pair.b == rod_b) || (pair.a == rod_b && pair.b == rod_a);
  });
}

bool place_allowed(const Rules& rules, const Structure& structure, int rod, double s) {
  const auto along = arc_length_of(structure, rod);
  // An arc's ends are forbidden also where a change of units rounds them.
  const double rounding = 1e-10 * along.length();
  const double at = along.wrap(s);
  const auto within = [&](double place, const Interval& span) {
    return place >= span.lower - rounding && place <= span.upper + rounding;
  };
  return std::ranges::none_of(rules.forbidden, [&](const Arc& arc) {
    if (arc.rod != rod) return false;
    const Interval span = unrolled(arc, along);
    if (within(at, span)) return true;
    return along.closed() &&
           (within(at + along.length(), span) || within(at - along.length(), span));
  });
}

bool is_unwanted(const Rules& rules, const std::vector<geometry::ArcLength>& along,
                 const springs::Cable& cable) {
  return std::ranges::any_of(rules.unwanted, [&](const springs::Cable& other) {
    return springs::alike(cable, other, along, unwanted_part);
  });
}

Interval sliding_interval(const Rules& rules, const Structure& structure, int rod, double s) {
  const auto along = arc_length_of(structure, rod);
  const double length = along.length();
  // Forbidden arcs include their ends, so bounds stay clear of them by a margin that is small
  // against any edge and large against rounding.
  const double clear = 1e-9 * length;
  Interval free = along.closed() ? Interval{s - length, s + length} : Interval{0.0, length};
  for (const auto& arc : rules.forbidden) {
    if (arc.rod != rod) continue;
    const Interval span = unrolled(arc, along);
    const double turns = along.closed() ? std::floor(s / length) * length : 0.0;
    for (const int k : {-2, -1, 0, 1}) {
      const double offset = along.closed() ? turns + k * length : 0.0;
      if (span.upper + offset < s) free.lower = std::max(free.lower, span.upper + offset + clear);
      if (span.lower + offset > s) free.upper = std::min(free.upper, span.lower + offset - clear);
    }
  }
  return {std::min(free.lower, s), std::max(free.upper, s)};
}

}  // namespace tencer::model
