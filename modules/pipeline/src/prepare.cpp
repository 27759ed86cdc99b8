#include <algorithm>
#include <cmath>
#include <sstream>
#include <tencer/core/names.hpp>
#include <tencer/equilibrium/frames.hpp>
#include <tencer/equilibrium/rigid_modes.hpp>
#include <tencer/ground_structure/candidates.hpp>
#include <tencer/model/frames.hpp>
#include <tencer/model/units.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/pipeline/surrounds.hpp>
#include <tencer/pipeline/symmetry.hpp>
#include <utility>

#include "strength.hpp"

namespace tencer::pipeline {
namespace {

using ground_structure::Problem;

// The rods at the target, with frames as the scene wants them and then in balance.
model::State start_of(const model::Scene& scene, const Problem& problem) {
  model::State state = make_state(problem.structure, problem.target.points);
  for (std::size_t r = 0; r < state.size(); ++r) {
    if (scene.directors[r])
      model::turn_frames(state[r], *scene.directors[r]);
    else
      model::turn_to_least_energy(problem.structure.rods[r], state[r]);
  }
  equilibrium::relax_frames(problem.structure, state);
  return state;
}

// Without pins and loads, cables to anchors can only balance when these surround the target (paper
// section 5.2).
std::optional<core::Error> check_anchors(const model::Scene& scene) {
  const model::Structure& structure = scene.structure;
  const bool loaded = !structure.point_loads.empty() || !structure.line_loads.empty();
  if (structure.anchors.cols() == 0 || !structure.pins.empty() || loaded || !scene.rules.external)
    return {};
  for (std::size_t r = 0; r < scene.target.points.size(); ++r) {
    const auto outside =
        furthest_outside(structure.anchors, scene.target.points[r], structure.planar);
    if (outside.point < 0) continue;
    std::ostringstream message;
    message << "anchors: their convex hull must enclose the target, but ";
    if (std::isinf(outside.distance))
      message << "these " << structure.anchors.cols() << " enclose nothing; give at least "
              << (structure.planar ? "3 that are not on a line" : "4 that are not in a plane");
    else
      message << "vertex " << outside.point << " of "
              << core::rod_in_words(r, structure.rods.size()) << " is " << outside.distance << ' '
              << scene.length_unit << " outside";
    return core::Error{scene.source, message.str()};
  }
  return {};
}

// Whatever the force at a pin turns out to be, there have to be anchors to take it over.
std::optional<core::Error> check_hand_over(const model::Scene& scene) {
  const model::Structure& structure = scene.structure;
  const double max_length = scene.rules.max_cable_length;
  if (!scene.design.hand_over) return {};
  for (const model::Pin& pin : structure.pins) {
    const Eigen::Vector3d point = scene.target.points[pin.rod].col(pin.vertex);
    Eigen::Matrix3Xd within(3, 0);
    for (const auto& anchor : structure.anchors.colwise()) {
      if ((anchor - point).norm() > max_length) continue;
      within.conservativeResize(3, within.cols() + 1);
      within.rightCols(1) = anchor;
    }
    // Well inside: on the hull itself some forces have no anchors.
    constexpr double clear = 1e-3;
    if (within.cols() > 0) {
      const Eigen::Vector3d centre = within.rowwise().mean();
      within = ((1 - clear) * (within.colwise() - centre)).colwise() + centre;
      if (furthest_outside(within, point, structure.planar).point < 0) continue;
    }
    std::ostringstream message;
    message << "design.hand_over: the anchors "
            << (std::isfinite(max_length) ? "that the longest cable reaches " : "")
            << "must surround every pinned vertex, but vertex " << pin.vertex << " of "
            << core::rod_in_words(pin.rod, structure.rods.size())
            << " is not between them; a frame, such as {shape = \"cube\"}, is about "
            << "all rods";
    return core::Error{scene.source, message.str()};
  }
  return {};
}

// Loads on rods that no pin holds, however cables tie the rods together.
std::optional<core::Error> check_loads(const model::Scene& scene, const Problem& problem) {
  model::Structure tied = problem.structure;
  if ((tied.line_loads.empty() && tied.point_loads.empty()) || problem.rules.external) return {};
  for (int r = 1; r < static_cast<int>(tied.rods.size()); ++r)
    tied.cables.push_back({.a = springs::OnRod{0, 0.0}, .b = springs::OnRod{r, 0.0}});
  const equilibrium::System system(tied);
  const auto modes = equilibrium::rigid_modes(system, make_state(tied, problem.target.points));
  if (equilibrium::holds_loads(system, modes)) return {};
  return core::Error{scene.source,
                     std::string(tied.line_loads.empty() ? "loads" : "gravity") +
                         ": nothing holds the rods against it, so they have no equilibrium; pin "
                         "vertices, or give anchors for cables"};
}

// What is wrong when there are no candidates: the error, with the key without whose rules there
// would be some.
std::string why_no_candidates(const Problem& problem, const core::Error& error) {
  using model::Rules;
  const auto allowed_but_for = [&](auto&& lift) {
    Rules rules = problem.rules;
    lift(rules);
    return ground_structure::candidates(problem.structure, problem.target.points, rules)
        .has_value();
  };
  if (allowed_but_for([](Rules& rules) { rules.max_cable_length = Rules{}.max_cable_length; }))
    return "design.longest_cable: " + error.message;
  if (allowed_but_for([](Rules& rules) { rules.pairs.reset(); }))
    return "design.rod_pairs: " + error.message;
  if (allowed_but_for([](Rules& rules) { rules.forbidden.clear(); })) {
    const bool arcs = std::ranges::any_of(problem.rules.forbidden,
                                          [](const model::Arc& arc) { return arc.from != arc.to; });
    return (arcs ? "design.forbidden_arcs: " : "design.forbidden_vertices: ") + error.message;
  }
  if (!error.where.empty()) return error.message;  // vertices coincide
  return "no cable is possible: the vertices are all neighbours on their rod, or held in place";
}

// The candidates of the problem into it.
std::optional<core::Error> add_candidates(const model::Scene& scene, Problem& problem) {
  auto found =
      ground_structure::candidates(problem.structure, problem.target.points, problem.rules);
  if (!found) return core::Error{scene.source, why_no_candidates(problem, found.error())};
  problem.candidates = std::move(*found);
  return std::nullopt;
}

// Edges of one rod whose lengths differ so much that no solver tells its forces from rounding.
std::optional<core::Error> check_edges(const model::Scene& scene) {
  constexpr double most = 1000;
  for (std::size_t r = 0; r < scene.structure.rods.size(); ++r) {
    const Eigen::VectorXd& lengths = scene.structure.rods[r].rest_lengths;
    Eigen::Index shortest = 0;
    Eigen::Index longest = 0;
    const double ratio = lengths.maxCoeff(&longest) / lengths.minCoeff(&shortest);
    if (ratio <= most) continue;
    std::ostringstream message;
    message.precision(3);
    message << core::rod_in_words(r, scene.structure.rods.size())
            << " has edges too uneven: from vertex " << shortest << " it is " << lengths[shortest]
            << ' ' << scene.length_unit << " to the next and from vertex " << longest << ' '
            << lengths[longest] << ' ' << scene.length_unit << ", 1 : " << ratio
            << " where 1 : 1000 is allowed; space the points more evenly (in a scene vertices = "
            << std::max<Eigen::Index>(100, lengths.size()) << " does so along the curve)";
    return core::Error{scene.source, message.str()};
  }
  return std::nullopt;
}

// What a scene that was put together by a program may have wrong.
std::optional<core::Error> check_scene(const model::Scene& scene) {
  if (scene.structure.rods.empty()) return core::Error{scene.source, "has no rods"};
  if (scene.directors.size() != scene.structure.rods.size())
    return core::Error{scene.source, "directors: expected one for each rod, set or not"};
  if (const auto problem = scene.design.problem())
    return core::Error{scene.source, "design." + *problem};
  if (const auto problem = scene.build.problem())
    return core::Error{scene.source, "build." + *problem};
  const auto& allowed = scene.build.max_deviation;
  if (allowed && allowed->unit != "%" &&
      std::ranges::count(model::length_units(), scene.length_unit) == 0)
    return core::Error{scene.source,
                       "build.max_deviation: say it in %, as length_unit is not "
                       "one that it could be converted to"};
  try {
    model::validate(scene.structure);
    model::validate(scene.target, scene.structure);
    model::validate(scene.rules, scene.structure);
  } catch (const std::invalid_argument& wrong) {
    return core::Error{scene.source, wrong.what()};
  }
  if (auto error = check_edges(scene)) return error;
  if (const auto crossing = model::crossing(scene)) return core::Error{scene.source, *crossing};
  return std::nullopt;
}

}  // namespace

core::Expected<Prepared> prepare(const model::Scene& scene) {
  for (const auto check : {check_scene, check_anchors, check_hand_over})
    if (auto error = check(scene)) return *error;
  Prepared prepared{.scaling = model::scaling_of(scene.structure, scene.target.points)};
  Problem& problem = prepared.problem;
  problem.structure = model::scaled(scene.structure, prepared.scaling);
  model::Rules rules = scene.rules;
  if (!rules.gaps) rules.gaps = scene.build.gaps();
  problem.rules = model::scaled(std::move(rules), prepared.scaling);
  problem.rules.external = scene.rules.external && scene.structure.anchors.cols() > 0;
  problem.target = {.points = model::scaled(scene.target.points, prepared.scaling),
                    .weights = scene.target.weights,
                    .align = scene.structure.pins.empty() && !problem.rules.external,
                    .planar = scene.structure.planar,
                    .views = scene.target.views};
  if (auto error = check_loads(scene, problem)) return *error;
  problem.start = start_of(scene, problem);
  if (auto error =
          check_bends(scene, problem.structure, problem.start, prepared.scaling.scale.length))
    return *error;
  if (scene.design.method == model::Method::force_balance) {
    auto group = symmetry_of(scene, problem, prepared.scaling);
    if (!group) return group.error();
    problem.symmetry = std::move(*group);
  }
  if (auto error = add_candidates(scene, problem)) return *error;
  return prepared;
}

core::Expected<Problem> without_pins(const model::Scene& scene, const Problem& pinned) {
  Problem released = pinned;
  released.structure.pins.clear();
  if (auto error = add_candidates(scene, released)) return *error;
  return released;
}

}  // namespace tencer::pipeline
