#include <algorithm>
#include <cmath>
#include <tencer/springs/alike.hpp>

namespace tencer::springs {
namespace {

bool near(const End& a, const End& b, std::span<const geometry::ArcLength> rods, double part) {
  if (a.index() != b.index()) return false;
  if (const auto* anchor = std::get_if<AtAnchor>(&a))
    return anchor->anchor == std::get<AtAnchor>(b).anchor;
  const auto& on_a = std::get<OnRod>(a);
  const auto& on_b = std::get<OnRod>(b);
  if (on_a.rod != on_b.rod) return false;
  const geometry::ArcLength& rod = rods[on_a.rod];
  double apart = std::abs(rod.wrap(on_a.s) - rod.wrap(on_b.s));
  if (rod.closed()) apart = std::min(apart, rod.length() - apart);
  return apart < part * rod.length();
}

}  // namespace

bool alike(const Cable& one, const Cable& other, std::span<const geometry::ArcLength> rods,
           double part) {
  return (near(one.a, other.a, rods, part) && near(one.b, other.b, rods, part)) ||
         (near(one.a, other.b, rods, part) && near(one.b, other.a, rods, part));
}

}  // namespace tencer::springs
