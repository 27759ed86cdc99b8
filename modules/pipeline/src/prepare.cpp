#include <cmath>
#include <sstream>
#include <tencer/equilibrium/rigid_modes.hpp>
#include <tencer/pipeline/convert.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/pipeline/surrounds.hpp>
#include <tencer/pipeline/symmetry.hpp>

#include "frames.hpp"
#include "parts.hpp"
#include "rest_shape.hpp"

namespace tencer::pipeline {
namespace {

// The design file of the scene as far as it is known before there are cables.
io::Design file_of(const io::Scene& scene) {
  io::Design design;
  design.name = scene.name;
  design.length_unit = scene.length_unit;
  design.force_unit = scene.force_unit;
  design.planar = scene.planar;
  design.anchors = scene.anchors;
  design.pinned = scene.pinned;
  design.point_loads = scene.point_loads;
  design.line_loads = scene.line_loads;
  for (const auto& from : scene.rods) {
    der::Rod rod{.closed = from.target.closed, .section = {}};
    rod.rest_lengths = geometry::edge_lengths(from.target);
    set_rest_shape(from.rest, rod);
    design.rods.push_back({.closed = rod.closed,
                           .EA = from.section.EA,
                           .EI = from.section.EI,
                           .GJ = from.section.GJ,
                           .rest_lengths = rod.rest_lengths,
                           .target = from.target.points,
                           .pose = from.target.points,
                           .closing_angle = from.closing_angle,
                           .rest_curvature = rod.rest_curvature,
                           .rest_twist = rod.rest_twist});
  }
  return design;
}

// The rods at the target, with frames as the scene wants them and then as they settle.
equilibrium::State start_of(const io::Scene& scene, const equilibrium::Structure& structure,
                            const std::vector<Eigen::Matrix3Xd>& points) {
  equilibrium::State state = make_state(structure, points);
  for (std::size_t r = 0; r < state.size(); ++r) {
    if (scene.rods[r].director)
      turn_frames(state[r], *scene.rods[r].director);
    else
      turn_to_least_energy(structure.rods[r], state[r]);
  }
  settle_frames(structure, state);
  return state;
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

// Without pins and loads, cables to anchors can only balance when these surround the target (paper
// section 5.2).
std::optional<core::Error> check_anchors(const io::Scene& scene) {
  const bool loaded = !scene.point_loads.empty() || !scene.line_loads.empty();
  if (scene.anchors.cols() == 0 || !scene.pinned.empty() || loaded || !scene.design.external)
    return {};
  for (const auto& rod : scene.rods) {
    const auto outside = furthest_outside(scene.anchors, rod.target.points, scene.planar);
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

// Whatever the force at a pin turns out to be, there have to be anchors to take it over.
std::optional<core::Error> check_hand_over(const io::Scene& scene) {
  if (!scene.design.hand_over) return {};
  for (const io::Pin& pin : scene.pinned) {
    const Eigen::Vector3d point = scene.rods[pin.rod].target.points.col(pin.vertex);
    Eigen::Matrix3Xd within(3, 0);
    for (const auto& anchor : scene.anchors.colwise()) {
      if ((anchor - point).norm() > scene.design.longest_cable.value_or(INFINITY)) continue;
      within.conservativeResize(3, within.cols() + 1);
      within.rightCols(1) = anchor;
    }
    // Well inside: on the hull itself some forces have no anchors.
    constexpr double clear = 1e-3;
    if (within.cols() > 0) {
      const Eigen::Vector3d centre = within.rowwise().mean();
      within = ((1 - clear) * (within.colwise() - centre)).colwise() + centre;
      if (furthest_outside(within, point, scene.planar).point < 0) continue;
    }
    std::ostringstream message;
    message << "design.hand_over: the anchors "
            << (scene.design.longest_cable ? "that the longest cable reaches " : "")
            << "must surround every pinned vertex, but vertex " << pin.vertex << " of rod "
            << pin.rod << " is not between them; a frame, such as {shape = \"cube\"}, is about "
            << "all rods";
    return core::Error{scene.source, message.str()};
  }
  return {};
}

// Loads on rods that no pin holds, however cables tie the rods together.
std::optional<core::Error> check_loads(const io::Scene& scene, const Prepared& prepared) {
  equilibrium::Structure tied = prepared.structure;
  if ((tied.line_loads.empty() && tied.point_loads.empty()) || prepared.rules.external) return {};
  for (int r = 1; r < static_cast<int>(tied.rods.size()); ++r)
    tied.cables.push_back({.a = springs::OnRod{0, 0.0}, .b = springs::OnRod{r, 0.0}});
  const equilibrium::System system(tied);
  const auto modes = equilibrium::rigid_modes(system, make_state(tied, prepared.target.points));
  if (equilibrium::holds_loads(system, modes)) return {};
  return core::Error{scene.source,
                     std::string(tied.line_loads.empty() ? "loads" : "gravity") +
                         ": nothing holds the rods against it, so they have no equilibrium; pin "
                         "vertices, or give anchors for cables"};
}

}  // namespace

core::Expected<Prepared> prepare(const io::Scene& scene) {
  if (auto error = check_anchors(scene)) return *error;
  if (auto error = check_hand_over(scene)) return *error;
  Prepared prepared{.file = file_of(scene)};
  prepared.units = units_of(prepared.file);
  prepared.structure = structure_of(prepared.file, Cables::inextensible, prepared.units);
  prepared.target.points = scaled_targets(prepared.file, prepared.units);
  for (const auto& rod : scene.rods) prepared.target.weights.push_back(rod.weights);
  prepared.rules = scaled_rules(scene, prepared.structure, prepared.units.scale);
  prepared.target.align = scene.pinned.empty() && !prepared.rules.external;
  prepared.target.planar = scene.planar;
  if (auto error = check_loads(scene, prepared)) return *error;
  prepared.start = start_of(scene, prepared.structure, prepared.target.points);
  for (std::size_t r = 0; r < prepared.start.size(); ++r)
    prepared.file.rods[r].target_directors = directors(prepared.start[r]);
  if (scene.design.method == "force-balance") {
    auto group = symmetry_of(scene, prepared);
    if (!group) return group.error();
    prepared.symmetry = std::move(*group);
  }
  prepared.parts = parts_of(scene, prepared);
  return prepared;
}

}  // namespace tencer::pipeline
