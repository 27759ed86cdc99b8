#include <algorithm>
#include <chrono>
#include <limits>
#include <string>
#include <tencer/core/words.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/model/frames.hpp>
#include <tencer/model/resolution.hpp>
#include <tencer/model/units.hpp>
#include <tencer/network/settling.hpp>
#include <tencer/pipeline/check.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/feasible.hpp>
#include <tencer/pipeline/omissions.hpp>
#include <tencer/pipeline/symmetry.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <utility>

#include "at_least.hpp"
#include "edit.hpp"
#include "methods.hpp"
#include "record.hpp"
#include "target_warnings.hpp"
#include "time_limit.hpp"

namespace tencer::pipeline {
namespace {

using model::Design;
using network::Network;

void say(const RunOptions& options, core::Level level, const std::string& text) {
  if (options.log) options.log(level, text);
}

// That a stage begins, before there is a network.
void tell_stage(std::string_view stage, const RunOptions& options) {
  options.progress({.stage = stage, .max_percent = std::numeric_limits<double>::quiet_NaN()});
}

void suggest_symmetry(const ground_structure::Problem& problem, const RunOptions& options) {
  if (!options.log) return;
  const std::string found = symmetry_in_words(problem);
  if (found.empty()) return;
  options.log(core::Level::info, "the target has " + found +
                                     ": with symmetry = \"detect\" in [design], or --symmetry "
                                     "detect, the cables have it too");
}

// What is known before the search: what was made of the input, bends that the rods do not hold,
// rods that touch, what is left out, symmetries.
void introduce(const Task& task, const RunOptions& options) {
  const model::Scene& scene = task.scene;
  const ground_structure::Problem& problem = task.prepared.problem;
  for (const std::string& note : scene.notes) say(options, core::Level::info, note);
  for (const std::string& warning :
       target_warnings(scene, problem.structure, problem.start, task.prepared.scaling.scale.length))
    say(options, core::Level::warning, warning);
  for (const Feature& feature : features_of(scene, task.prepared))
    if (!feature.used) say(options, core::Level::debug, "no " + feature.name + ": " + feature.why);
  if (scene.design.symmetry == model::SymmetryUse::suggest &&
      scene.design.method == model::Method::force_balance)
    suggest_symmetry(problem, options);
}

core::Expected<Task> task_of(const model::Scene& scene, const RunOptions& options) {
  const model::DesignSettings& settings = scene.design;
  tell_stage("prepare", options);
  Task task{.scene = scene};
  // The steps of force-balance's own are Gauss-Newton's: they need no backend.
  if (settings.method == model::Method::dense_springs ||
      settings.optimizer != model::Optimizer::gauss_newton) {
    auto backend = optimize::find_backend(options.backends, model::name_of(settings.optimizer));
    if (!backend) return core::Error{scene.source, "design.optimizer: " + backend.error().message};
    task.backend = std::move(*backend);
  }
  if (const auto wrong = model::hessian_problem(settings.method, settings.hessian))
    return core::Error{scene.source, "design.hessian: " + *wrong};
  auto prepared = prepare(scene);
  if (!prepared) return prepared.error();
  task.prepared = std::move(*prepared);
  if (settings.hand_over) {
    auto released = without_pins(scene, task.prepared.problem);
    if (!released) return released.error();
    task.released = std::move(*released);
  }
  return task;
}

core::Expected<Task> begin(const model::Scene& scene, const RunOptions& options) {
  auto task = task_of(scene, options);
  if (!task) return task;
  introduce(*task, options);
  if (options.feasible_first) {
    tell_stage("feasible", options);
    const auto found =
        feasible(scene, {.mends = TryMends::if_it_cannot, .at_least = false, .stop = options.stop});
    if (!found) return found.error();
    if (found->verdict == model::Verdict::cannot)
      return core::Error{scene.source, model::reason(*found)};
  }
  return task;
}

// The scene's design with the network's cables; what depends on the equilibrium is missing.
Design design_of(const Task& task, const Network& network) {
  const model::Scene& scene = task.scene;
  const model::Scaling& scaling = task.prepared.scaling;
  Design design{.name = scene.name,
                .length_unit = scene.length_unit,
                .force_unit = scene.force_unit,
                .structure = scene.structure,
                .target = scene.target.points,
                .views = scene.target.views,
                .pose = scene.target.points,
                .goal = goal_of(scene.design)};
  if (network.structure.pins.empty()) design.structure.pins.clear();  // they may be handed over
  for (const auto& cable : network.structure.cables)
    design.structure.cables.push_back(model::unscaled(cable, network.structure, scaling));
  for (const auto& rod : task.prepared.problem.start)
    design.target_directors.push_back(model::directors(rod));
  design.pose_directors = design.target_directors;
  return design;
}

Design recorded(const Task& task, const Network& network) {
  Design design = design_of(task, network);
  record({.structure = network.structure,
          .state = network.state,
          .tensions = cable_tensions(network),
          .target = task.prepared.problem.target},
         task.prepared.scaling, design);
  return design;
}

// Lets the built network go at the target and compares with the pose that the design claims.
model::StageRow check_settling(const Task& task, const Network& network, Design& design) {
  const ground_structure::Problem& problem = task.prepared.problem;
  const auto begin = std::chrono::steady_clock::now();
  const auto settling = network::settle(network, problem.start, problem.target);
  const auto& found = settling.equilibrium;
  model::Target target = model::make_target(network.structure, problem.target.points);
  target.views = problem.target.views;
  const auto deviation = sensitivity::deviation(target, found.state);
  model::StageRow row{
      .stage = "settle",
      .seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
      .cables = cable_count(network),
      .max_percent = deviation.max_percent,
      .rms_percent = deviation.rms_percent,
      .solves = 1,
      .iterations = found.iterations};
  if (!found.usable())
    row.note = "with inextensible cables, from the target: " + describe(found.reason);
  else if (!settling.in_pose())
    row.note = "from the target the built form settles elsewhere, " +
               std::to_string(settling.moved_percent) + " % away from the pose";
  design.certificate->settles_from_target = settling.in_pose();
  return row;
}

// As the scene's [build] asks for it.
CheckOptions check_options(const Task& task, const Design& design, const RunOptions& options) {
  constexpr int draws = 2000;
  const model::Scene& scene = task.scene;
  const double mm = 1000 * model::metres(scene.length_unit);
  // With a number of cables given, the pose may be further from the target than the max error.
  const double percent = scene.design.cables
                             ? std::max(scene.design.max_error, design.error->max_percent)
                             : scene.design.max_error;
  return {.length_error_mm = scene.build.length_error_in(scene.length_unit) * mm,
          .attachment_error_mm = scene.build.attachment_error_in(scene.length_unit) * mm,
          .max_deviation = scene.build.max_deviation.value_or(model::Allowance{percent}),
          .draws = draws,
          .most_times = 1,
          .stop = options.stop};
}

// What is looked at of being built.
model::Check check_building(const Task& task, const Design& design, const RunOptions& options) {
  model::Check check = quick_check(design, check_options(task, design, options));
  if (task.scene.build.layers) check.clear->cable_rod.reset();
  return check;
}

// Tells also of a design that falls short to first order how it settles with errors.
void let_settle(const Task& task, Design& design, const RunOptions& options) {
  if (!design.check || !design.check->forgives || design.check->forgives->settled > 0) return;
  design.check->forgives = forgiven_errors(design, check_options(task, design, options));
}

// What the number of its cables is to be compared with: within the error that was asked for, or, of
// a number of cables, as near as it comes.
// Of what is seen from a side only nothing is known.
std::optional<model::AtLeast> needed(const Task& task, const Design& design,
                                     const RunOptions& options) {
  if (!design.views.empty()) return std::nullopt;
  const model::Goal goal = goal_of(task.scene.design);
  return at_least(task.prepared,
                  goal.by_number() ? design.error->max_percent : goal.max_error_percent,
                  options.stop);
}

// The design of a network: complete unless it falls short of something.
Design certified(const Task& task, const Network& network, const RunOptions& options) {
  Design design = recorded(task, network);
  const auto tell = [&](std::string_view stage) {
    options.progress(
        {.stage = stage, .cables = cable_count(network), .max_percent = design.error->max_percent});
  };
  tell("settle");
  design.trace.push_back(check_settling(task, network, design));
  const bool unit_known = std::ranges::count(model::length_units(), design.length_unit) > 0;
  tell("check");
  if (design.certificate->stable && cable_count(network) > 0 && unit_known)
    design.check = check_building(task, design, options);
  design.status = model::shortfalls(design).empty() ? model::DesignStatus::complete
                                                    : model::DesignStatus::tolerance_not_reached;
  return design;
}

// A network that was not solved for yet when the search was stopped, where it comes to rest: only
// there is it as far from the target as it is. Whoever stopped it does not wait long.
Network solved(Network network) {
  constexpr double balanced = 1e-6;
  const equilibrium::System system(network.structure);
  if (equilibrium::residual(system, network.state) > balanced)
    network.state = equilibrium::solve(system, network.state, {.max_iterations = 100}).state;
  return network;
}

// The networks certified one after the other, from the one asked for on, until one stands; else the
// first of the best footing. One that is much further from the target than another is no better.
// Its row of the trace comes last.
Design first_answer(const Task& task, const Outcome& outcome, const RunOptions& options) {
  constexpr int max_tries = 6;
  const model::Goal goal = goal_of(task.scene.design);
  const int step = goal.by_number() ? -1 : 1;
  const auto count = static_cast<int>(outcome.networks.size());
  Design best;
  std::vector<model::StageRow> checks;
  for (int k = 0, i = outcome.asked; k < max_tries && i >= 0 && i < count; i += step, ++k) {
    Design next = certified(task, outcome.networks[i], options);
    for (const std::string& shortfall : model::shortfalls(next))
      say(options, core::Level::debug,
          core::counted(cable_count(outcome.networks[i]), "cable") + ": " + shortfall);
    const model::Score score = score_of(next);
    const bool better = k > 0 && score.footing > score_of(best).footing &&
                        goal.prefers_footing(score, score_of(best));
    if (k == 0 || better) std::swap(best, next);
    if (!next.trace.empty()) checks.push_back(next.trace.back());
    if (score_of(best).stands()) break;
  }
  if (!outcome.interrupted) let_settle(task, best, options);
  checks.push_back(best.trace.back());
  best.trace = outcome.trace;
  best.trace.insert(best.trace.end(), checks.begin(), checks.end());
  return best;
}

model::Scene ready_to_design(const model::Scene& scene) {
  model::Scene ready = model::with_enough_vertices(scene);
  if (ready.edit) apply_edit(ready);
  return ready;
}

// Networks that a stop left without a solution are solved for.
Outcome run_in_time(const Task& task, bool every_number, const RunOptions& options) {
  const TimeLimit limit(task.scene.design.time, options.stop);
  RunOptions timed = options;
  timed.stop = limit.token();
  Outcome outcome = run_method(task, every_number, timed);
  if (outcome.interrupted) {
    for (Network& network : outcome.networks) network = solved(std::move(network));
    if (!options.stop.stop_requested())
      say(options, core::Level::info, "the time is up: the last checks follow");
  }
  return outcome;
}

}  // namespace

model::Goal goal_of(const model::DesignSettings& settings) {
  return {.max_error_percent = settings.max_error, .cables = settings.cables.value_or(0)};
}

const Design& best_for(const model::Goal& goal, std::span<const Design> designs) {
  // Not by their status, which says of all of them that the run was interrupted when it was.
  const auto picked = [&](auto&& counts) -> const Design* {
    std::vector<model::Score> scores;
    std::vector<const Design*> counted;
    for (const Design& design : designs)
      if (counts(design)) {
        scores.push_back(score_of(design));
        counted.push_back(&design);
      }
    const int at = goal.pick(scores);
    return at < 0 ? nullptr : counted[at];
  };
  const Design* standing = picked([](const Design& design) { return score_of(design).stands(); });
  if (standing && goal.met(score_of(*standing))) return *standing;
  return *picked([](const Design&) { return true; });
}

std::optional<core::Error> scene_problem(const model::Scene& scene, const RunOptions& options) {
  if (auto error = check_edit(scene)) return error;
  const model::Scene ready = ready_to_design(scene);
  const auto task = task_of(ready, options);
  return task ? std::nullopt : std::optional(task.error());
}

core::Expected<Design> design(const model::Scene& scene, const RunOptions& options) {
  if (const auto error = check_edit(scene)) return *error;
  const model::Scene ready = ready_to_design(scene);
  const auto task = begin(ready, options);
  if (!task) return task.error();
  const Outcome outcome = run_in_time(*task, false, options);
  if (!options.stop.stop_requested()) {
    Design answer = first_answer(*task, outcome, options);
    answer.at_least = needed(*task, answer, options);
    return answer;
  }
  Design best = recorded(*task, outcome.networks[outcome.asked]);
  best.trace = outcome.trace;
  best.status = model::DesignStatus::interrupted;
  return best;
}

core::Expected<std::vector<Design>> trade_off(const model::Scene& scene,
                                              const RunOptions& options) {
  if (const auto error = check_edit(scene)) return *error;
  if (scene.edit && scene.edit->cables())
    return core::Error{scene.source,
                       "edit: add and remove ask for one number of cables, a trade-off for all"};
  const model::Scene ready = ready_to_design(scene);
  const auto task = begin(ready, options);
  if (!task) return task.error();
  const Outcome outcome = run_in_time(*task, true, options);
  std::vector<Design> designs;
  for (const Network& network : outcome.networks) {
    Design next = certified(*task, network, options);
    if (!outcome.interrupted) let_settle(*task, next, options);
    next.trace.insert(next.trace.begin(), outcome.trace.begin(), outcome.trace.end());
    if (options.stop.stop_requested()) next.status = model::DesignStatus::interrupted;
    // Of an error that was asked for it is the same for all.
    next.at_least = designs.empty() || goal_of(ready.design).by_number()
                        ? needed(*task, next, options)
                        : designs.front().at_least;
    designs.push_back(std::move(next));
  }
  // All come from one search, which one of them shows.
  const Design& shown = best_for(goal_of(ready.design), designs);
  for (Design& design : designs)
    if (&design != &shown)
      for (auto& row : design.trace) row.snapshots.clear();
  return designs;
}

}  // namespace tencer::pipeline
