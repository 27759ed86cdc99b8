#include <algorithm>
#include <chrono>
#include <cmath>
#include <tencer/geometry/corners.hpp>
#include <tencer/ground_structure/feasibility.hpp>
#include <tencer/ground_structure/neighbours.hpp>
#include <tencer/model/resolution.hpp>
#include <tencer/pipeline/feasible.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <utility>

#include "at_least.hpp"
#include "mends.hpp"
#include "target_warnings.hpp"

namespace tencer::pipeline {
namespace {

using ground_structure::Problem;
using model::Feasibility;
using model::Verdict;

// The scene with as many vertices as tell the verdict, if it has clearly more.
model::Scene with_few_vertices(const model::Scene& scene) {
  constexpr double enough = 130;    // of all rods
  constexpr double max_turn = 0.3;  // of a vertex, radians
  constexpr int min_vertices = 24;  // of a rod
  constexpr double worthwhile = 0.8;
  double vertices = 0;
  for (const auto& points : scene.target.points) vertices += static_cast<double>(points.cols());
  bool fewer = false;
  std::vector<double> times;
  for (std::size_t r = 0; r < scene.target.points.size(); ++r) {
    const geometry::Polyline curve = target_curve(scene, r);
    const double needed = std::max<double>(min_vertices, geometry::total_turning(curve) / max_turn);
    const double part = std::max(enough / vertices, needed / curve.vertices());
    times.push_back(part < worthwhile ? part : 1.0);
    fewer = fewer || part < worthwhile;
  }
  return fewer ? model::at_resolution(scene, times) : scene;
}

// How many steps of Newton's method may prove that the rods fall. The edges of a rough curve store
// so much that they take far more, and what is wrong is known.
int max_iterations(const std::vector<geometry::Polyline>& targets) {
  return std::ranges::any_of(targets, geometry::is_rough) ? 200 : 800;
}

double far_percent(const model::DesignSettings& settings) {
  const double fallen = settings.cables ? 10.0 : 2.0;
  return std::max(5 * settings.max_error, fallen);
}

// What a problem's candidates do.
struct Look {
  ground_structure::Relaxation relaxation{};
  ground_structure::TiedRest rest{};
  std::optional<ground_structure::Separation> separation{};
};

std::optional<Look> look(const Problem& problem, const ground_structure::TiedRestOptions& options) {
  const equilibrium::System bare(problem.structure);
  const auto candidates =
      ground_structure::candidate_orbits(bare, problem.start, problem.candidates, nullptr);
  auto first = ground_structure::relaxation(bare, problem.start, candidates);
  if (!first) return std::nullopt;
  auto rest = ground_structure::tied_rest(problem, candidates, *first, options);
  auto separation = ground_structure::separation(problem, candidates);
  return Look{std::move(*first), std::move(rest), std::move(separation)};
}

// With cables between neighbours only where there are many rods: where these are enough, so are
// all.
std::optional<Look> look_at_neighbours_first(const Problem& problem,
                                             const ground_structure::TiedRestOptions& options) {
  constexpr std::size_t many_rods = 4;
  if (problem.structure.rods.size() >= many_rods && !problem.rules.pairs) {
    Problem fewer = problem;
    fewer.candidates =
        ground_structure::among_neighbours(problem.candidates, problem.target.points);
    auto found = look(fewer, options);
    const bool holds = found && !found->separation && found->rest.rests &&
                       found->rest.max_percent <= options.near_percent;
    if (holds) return found;
  }
  return look(problem, options);
}

// What cannot be held where the target is may be held where it looks the same.
Verdict verdict_of(const Look& look, const Problem& problem,
                   const model::DesignSettings& settings) {
  const ground_structure::TiedRest& rest = look.rest;
  const bool elsewhere = !problem.target.views.empty();
  if (look.separation) return elsewhere ? Verdict::unclear : Verdict::cannot;
  if (rest.rests && rest.max_percent <= settings.max_error) return Verdict::can;
  if (elsewhere) return Verdict::unclear;
  return rest.proves_motion() && rest.max_percent > far_percent(settings) ? Verdict::cannot
                                                                          : Verdict::unclear;
}

// How each vertex moves from the target, which is where the rods rest best.
std::vector<Eigen::Matrix3Xd> motions_of(const Problem& problem, const model::State& state,
                                         double length) {
  const auto back = sensitivity::deviation(problem.target, state).motion;
  std::vector<Eigen::Matrix3Xd> motions;
  for (std::size_t r = 0; r < state.size(); ++r) {
    const Eigen::Matrix3Xd& target = problem.target.points[r];
    motions.push_back(length * back.rotation.transpose() * (state[r].x - back.apply(target)));
  }
  return motions;
}

// The same of rods that are drawn together: the largest is a tenth of the target's size.
std::vector<Eigen::Matrix3Xd> motions_of(const Problem& problem, const Eigen::VectorXd& motion,
                                         double length) {
  const equilibrium::System bare(problem.structure);
  std::vector<Eigen::Matrix3Xd> motions;
  double largest = 0;
  for (int r = 0; r < static_cast<int>(problem.structure.rods.size()); ++r) {
    Eigen::Matrix3Xd& own =
        motions.emplace_back(Eigen::Matrix3Xd::Zero(3, problem.structure.rods[r].vertices()));
    for (int v = 0; v < own.cols(); ++v)
      for (int axis = 0; axis < 3; ++axis)
        if (const int at = bare.position_index(r, v, axis); at >= 0) own(axis, v) = motion[at];
    largest = std::max(largest, own.colwise().norm().maxCoeff());
  }
  for (auto& own : motions) own *= 0.1 * model::diagonal(problem.target) * length / largest;
  return motions;
}

void fill(const Problem& problem, const Look& look, double length, Feasibility& result) {
  const double diagonal = model::diagonal(problem.target);
  result.cables = static_cast<int>(problem.candidates.size());
  result.percent = look.rest.max_percent;
  result.rests = look.rest.rests;
  result.released = look.rest.released;
  result.lengthening = look.rest.lengthening;
  result.unbalanced = 100 * look.relaxation.largest / diagonal;
  const double energy = equilibrium::System(problem.structure).energy(problem.start);
  result.power = energy != 0 ? look.relaxation.power / std::abs(energy) : 0;
  result.motions = motions_of(problem, look.rest.state, length);
  if (look.separation) {
    result.motions = motions_of(problem, look.separation->motion, length);
    result.apart = look.separation->rods;
  }
}

bool asked_for(TryMends mends, Verdict verdict) {
  if (mends == TryMends::never) return false;
  return verdict == Verdict::cannot ||
         (verdict == Verdict::unclear && mends == TryMends::unless_it_can);
}

// What does not help need not be proved not to.
Trial trial_of(const model::Scene& scene, const FeasibleOptions& options) {
  return [&](const model::Scene& changed) -> std::optional<double> {
    constexpr int few_iterations = 200;
    if (options.stop.stop_requested()) return std::nullopt;
    const auto prepared = prepare(changed);
    if (!prepared) return std::nullopt;
    const auto tried =
        look_at_neighbours_first(prepared->problem, {.near_percent = scene.design.max_error,
                                                     .max_iterations = few_iterations,
                                                     .stop = options.stop});
    if (!tried || tried->separation) return std::nullopt;
    return tried->rest.max_percent;
  };
}

// Of the vertices that a design has.
model::AtLeast needed(const model::Scene& scene, const std::stop_token& stop) {
  const auto prepared = prepare(scene);
  return prepared ? at_least(*prepared, scene.design.max_error, stop) : model::AtLeast{};
}

}  // namespace

core::Expected<Feasibility> feasible(const model::Scene& scene, const FeasibleOptions& options) {
  // Of all rods: more are not tied at once, as its time grows with their cube.
  constexpr int max_vertices = 700;
  const auto begin = std::chrono::steady_clock::now();
  const model::Scene coarse = with_few_vertices(scene);
  int vertices = 0;
  for (const auto& rod : coarse.structure.rods) vertices += rod.vertices();
  if (vertices > max_vertices)
    return Feasibility{.name = scene.name,
                       .length_unit = scene.length_unit,
                       .verdict = Verdict::unclear,
                       .max_error = scene.design.max_error,
                       .vertices = vertices};
  const auto prepared = prepare(coarse);
  if (!prepared) return prepared.error();
  const Problem& problem = prepared->problem;
  const double length = prepared->scaling.scale.length;
  Feasibility result{.name = scene.name,
                     .length_unit = scene.length_unit,
                     .max_error = scene.design.max_error,
                     .vertices = vertices,
                     .targets = target_curves(coarse)};
  const auto found =
      look_at_neighbours_first(problem, {.near_percent = scene.design.max_error,
                                         .max_iterations = max_iterations(result.targets),
                                         .stop = options.stop});
  result.warnings = target_warnings(coarse, problem.structure, problem.start, length);
  if (!found)
    return core::Error{
        scene.source,
        "the rods' stiffness at the target is not finite; " +
            (result.warnings.empty()
                 ? "space its points more evenly"
                 : "space its points more evenly, or round its corners, such as this one: " +
                       result.warnings.front())};
  fill(problem, *found, length, result);
  result.verdict = verdict_of(*found, problem, scene.design);
  if (options.at_least && result.verdict != Verdict::cannot && problem.target.views.empty())
    result.at_least = needed(scene, options.stop);
  if (asked_for(options.mends, result.verdict))
    result.mends = try_mends(coarse, trial_of(scene, options));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace tencer::pipeline
