#include "cables/cable_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tencer/core/error.hpp>

namespace tencer::symmetry {
namespace {

// A number for a pair of cells; pairs that share it by chance are told apart by their distance.
std::uint64_t key(std::uint64_t a, std::uint64_t b) { return (a << 32) ^ b; }

}  // namespace

double apart(const springs::End& a, const springs::End& b,
             std::span<const geometry::ArcLength> rods) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (a.index() != b.index()) return never;
  if (const auto* anchor = std::get_if<springs::AtAnchor>(&a))
    return anchor->anchor == std::get<springs::AtAnchor>(b).anchor ? 0.0 : never;
  const auto& on_a = std::get<springs::OnRod>(a);
  const auto& on_b = std::get<springs::OnRod>(b);
  if (on_a.rod != on_b.rod) return never;
  const geometry::ArcLength& rod = rods[on_a.rod];
  const double distance = rod.wrap(on_a.s) - rod.wrap(on_b.s);
  return std::abs(rod.closed() ? std::remainder(distance, rod.length()) : distance) / rod.length();
}

CableIndex::CableIndex(std::span<const geometry::ArcLength> rods, double tolerance)
    : rods_(rods),
      tolerance_(tolerance),
      cells_(static_cast<std::uint64_t>(std::min(1.0 / tolerance, 1e6))) {
  core::require(tolerance > 0.0 && tolerance < 0.01,
                "symmetry: the tolerance for cables must be between 0 and 0.01");
}

std::uint64_t CableIndex::cell(const springs::End& end, int step) const {
  const std::uint64_t per_rod = cells_ + 2;
  if (const auto* anchor = std::get_if<springs::AtAnchor>(&end))
    return per_rod * rods_.size() + anchor->anchor;
  const auto& on_rod = std::get<springs::OnRod>(end);
  const geometry::ArcLength& rod = rods_[on_rod.rod];
  // One cell is kept free below the first and above the last, for neighbours on open rods.
  const auto count = static_cast<std::int64_t>(cells_);
  std::int64_t at =
      static_cast<std::int64_t>(rod.wrap(on_rod.s) / rod.length() * static_cast<double>(count));
  at = std::min(at, count - 1) + step;
  if (rod.closed()) at = (at + count) % count;
  return per_rod * on_rod.rod + static_cast<std::uint64_t>(at + 1);
}

void CableIndex::add(const springs::Cable& cable, int value) {
  by_cells_[key(cell(cable.a, 0), cell(cable.b, 0))].push_back(static_cast<int>(entries_.size()));
  entries_.push_back({cable, value});
}

std::optional<CableIndex::Found> CableIndex::find(const springs::Cable& cable) const {
  std::optional<Found> best;
  double least = tolerance_;
  int first = 0;
  for (const bool swapped : {false, true}) {
    const springs::End& a = swapped ? cable.b : cable.a;
    const springs::End& b = swapped ? cable.a : cable.b;
    const int reach_a = std::holds_alternative<springs::OnRod>(a) ? 1 : 0;
    const int reach_b = std::holds_alternative<springs::OnRod>(b) ? 1 : 0;
    for (int i = -reach_a; i <= reach_a; ++i) {
      for (int j = -reach_b; j <= reach_b; ++j) {
        const auto bucket = by_cells_.find(key(cell(a, i), cell(b, j)));
        if (bucket == by_cells_.end()) continue;
        for (const int entry : bucket->second) {
          const springs::Cable& other = entries_[entry].cable;
          const double distance = std::max(apart(a, other.a, rods_), apart(b, other.b, rods_));
          if (distance > least || (best && distance == least && entry >= first)) continue;
          best = Found{entries_[entry].value, swapped};
          least = distance;
          first = entry;
        }
      }
    }
  }
  return best;
}

}  // namespace tencer::symmetry
