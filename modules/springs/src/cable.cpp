#include <cmath>
#include <sstream>
#include <tencer/core/error.hpp>
#include <tencer/core/names.hpp>
#include <tencer/springs/cable.hpp>

namespace tencer::springs {

void validate(const Cable& cable, int rods, int anchors) {
  for (const End& end : {cable.a, cable.b}) {
    if (const auto* on_rod = std::get_if<OnRod>(&end)) {
      core::require(on_rod->rod >= 0 && on_rod->rod < rods, "cable: no such rod");
      core::require(std::isfinite(on_rod->s), "cable: s must be finite");
    } else {
      const int anchor = std::get<AtAnchor>(end).anchor;
      core::require(anchor >= 0 && anchor < anchors, "cable: no such anchor");
    }
  }
  core::require(std::holds_alternative<OnRod>(cable.a) || std::holds_alternative<OnRod>(cable.b),
                "cable: at least one end must be on a rod");
  core::require(cable.stiffness >= 0 && std::isfinite(cable.stiffness),
                "cable: stiffness must be finite and >= 0");
  core::require(cable.rest_length >= 0 && std::isfinite(cable.rest_length),
                "cable: rest_length must be finite and >= 0");
}

Stencil stencil(const Cable& cable, std::span<const geometry::ArcLength> rods,
                const Eigen::Matrix3Xd& anchors, geometry::Side side) {
  Stencil result;
  const auto add = [&](const End& end, double sign) {
    if (const auto* at_anchor = std::get_if<AtAnchor>(&end)) {
      result.offset += sign * anchors.col(at_anchor->anchor);
      return;
    }
    const auto& on_rod = std::get<OnRod>(end);
    const geometry::ArcLength& rod = rods[on_rod.rod];
    const geometry::Location at = rod.locate(on_rod.s, side);
    const int next = rod.closed() && at.edge + 1 == rod.edges() ? 0 : at.edge + 1;
    result.shares[result.count++] = {on_rod.rod, at.edge, sign * (1 - at.t)};
    result.shares[result.count++] = {on_rod.rod, next, sign * at.t};
  };
  add(cable.a, -1.0);
  add(cable.b, 1.0);
  return result;
}

std::string describe(const Cable& cable) {
  std::ostringstream text;
  const auto add = [&](const End& end) {
    if (const auto* anchor = std::get_if<AtAnchor>(&end))
      text << core::anchor_name(anchor->anchor);
    else
      text << core::rod_name(std::get<OnRod>(end).rod) << " at " << std::get<OnRod>(end).s;
  };
  add(cable.a);
  text << " - ";
  add(cable.b);
  return text.str();
}

}  // namespace tencer::springs
