#include <algorithm>
#include <sstream>
#include <tencer/geometry/hull.hpp>
#include <tencer/pipeline/prepare.hpp>

#include "units_sum.hpp"

namespace tencer::pipeline {
namespace {

Units units_of(const io::Scene& scene) {
  UnitsSum sum;
  for (const auto& rod : scene.rods)
    sum.add(geometry::edge_lengths(rod.target).sum(), rod.section.EI.maxCoeff(), rod.target.points);
  return sum.units();
}

der::Rod scaled_rod(const io::SceneRod& from, const core::Scale& scale) {
  der::Rod rod;
  rod.closed = from.target.closed;
  rod.section = {.EA = from.section.EA / scale.force(),
                 .EI1 = from.section.EI[0] / scale.bending(),
                 .EI2 = from.section.EI[1] / scale.bending(),
                 .GJ = from.section.GJ / scale.bending()};
  rod.rest_lengths = geometry::edge_lengths(from.target) / scale.length;
  return rod;
}

sparsify::Rules scaled_rules(const io::Scene& scene, const equilibrium::Structure& structure,
                             const core::Scale& scale) {
  sparsify::Rules rules;
  if (scene.design.rod_pairs) {
    rules.pairs.emplace();
    for (const auto& [a, b] : *scene.design.rod_pairs) rules.pairs->push_back({a, b});
  }
  if (scene.design.longest_cable) rules.longest = *scene.design.longest_cable / scale.length;
  rules.external = scene.design.external && scene.anchors.cols() > 0;
  for (int r = 0; r < static_cast<int>(scene.rods.size()); ++r) {
    const geometry::ArcLength arc(structure.rods[r].rest_lengths, structure.rods[r].closed);
    for (const io::Arc& forbidden : scene.rods[r].forbidden_arcs)
      rules.forbidden.push_back(
          {.rod = r, .from = forbidden.from / scale.length, .to = forbidden.to / scale.length});
    for (int vertex : scene.rods[r].forbidden_vertices)
      rules.forbidden.push_back({.rod = r, .from = arc.knots()[vertex], .to = arc.knots()[vertex]});
  }
  return rules;
}

std::vector<std::string> what_is_left_out(const equilibrium::Structure& structure,
                                          const sensitivity::Target& target,
                                          const sparsify::Rules& rules) {
  std::vector<std::string> list;
  const auto carries_no_twist = [](const der::Rod& rod) {
    return der::twist_model(rod) == der::TwistModel::none;
  };
  if (std::ranges::all_of(structure.rods, carries_no_twist))
    list.push_back("no twist: every rod is straight at rest, isotropic and free to spin");
  if (structure.planar) list.push_back("no z: the scene is planar");
  if (!target.align) list.push_back("no registration: anchors or pins hold the structure in place");
  if (!rules.external) list.push_back("no external cables: the scene has no anchors");
  return list;
}

// Without pins, cables to anchors can only balance when these surround the target (paper section
// 5.2).
std::optional<core::Error> check_anchors(const io::Scene& scene) {
  if (scene.anchors.cols() == 0 || !scene.pinned.empty() || !scene.design.external) return {};
  for (const auto& rod : scene.rods) {
    const auto outside = geometry::outside_hull(scene.anchors, rod.target.points, scene.planar);
    if (outside.point < 0) continue;
    std::ostringstream message;
    message << "anchors: their convex hull must enclose the target, but ";
    if (std::isinf(outside.distance))
      message << "these " << scene.anchors.cols() << " enclose nothing; give at least "
              << (scene.planar ? "3 that are not on a line" : "4 that are not in a plane");
    else
      message << "vertex " << outside.point << " of rod " << (&rod - scene.rods.data()) << " is "
              << outside.distance << ' ' << scene.length_unit << " outside";
    return core::Error{scene.source, message.str()};
  }
  return {};
}

}  // namespace

core::Expected<Prepared> prepare(const io::Scene& scene) {
  if (auto error = check_anchors(scene)) return *error;
  Prepared prepared{.units = units_of(scene)};
  const Units& units = prepared.units;
  equilibrium::Structure& structure = prepared.structure;
  for (const auto& rod : scene.rods) {
    structure.rods.push_back(scaled_rod(rod, units.scale));
    prepared.target.points.push_back(units.scaled(rod.target.points));
    prepared.target.weights.push_back(rod.weights);
  }
  structure.anchors = units.scaled(scene.anchors);
  for (const io::Pin& pin : scene.pinned)
    structure.pins.push_back({.rod = pin.rod, .vertex = pin.vertex, .axes = pin.axes});
  structure.planar = scene.planar;
  prepared.rules = scaled_rules(scene, structure, units.scale);
  prepared.target.align = structure.pins.empty() && !prepared.rules.external;
  prepared.target.planar = scene.planar;
  prepared.left_out = what_is_left_out(structure, prepared.target, prepared.rules);
  return prepared;
}

}  // namespace tencer::pipeline
