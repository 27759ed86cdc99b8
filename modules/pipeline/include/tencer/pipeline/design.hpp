// From a scene to certified networks of cables.
#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <tencer/core/error.hpp>
#include <tencer/core/log.hpp>
#include <tencer/model/design.hpp>
#include <tencer/model/goal.hpp>
#include <tencer/model/scene.hpp>
#include <tencer/network/stage.hpp>
#include <tencer/optimize/backend.hpp>
#include <tencer/pipeline/backends.hpp>
#include <vector>

namespace tencer::pipeline {

// How a design is watched and stopped, and who solves its outer problems.
struct RunOptions {
  std::vector<optimize::Backend> backends = pipeline::backends();
  // The best design so far is returned, marked as interrupted and without the last check.
  std::stop_token stop{};
  // Called by one thread at a time, not always the same one; a stage that begins has no cables yet,
  // and its error is NaN.
  network::ProgressSink progress{};
  core::Log log{};  // may be empty; called by the thread that designs
  // Whether to look first if cables can hold the shape (pipeline/feasible.hpp); that they cannot is
  // an error, before a search that would find nothing.
  bool feasible_first = true;
};

// The scene's method: force balance at the target, or dense springs with pruning, greedy removal,
// sparsification and sliding; then elimination. Of the networks found the one the scene asks for
// (design.cables, else the fewest cables within design.max_error) is certified in its built form,
// with inextensible cables, and let go at the target, from where it has to settle into the reported
// pose; when it fails, the next best are tried. A target in which the rods rest by themselves has a
// design without cables. Rods with more vertices than their bends need are designed with fewer
// (model/resolution.hpp), which the log says. Errors name the scene's source and the key: an
// optimizer that is not in the build, rules that allow no cable, a rod that crosses itself, anchors
// that do not enclose the target.
core::Expected<model::Design> design(const model::Scene& scene, const RunOptions& options = {});

// What design() refuses of the scene, known without a search.
std::optional<core::Error> scene_problem(const model::Scene& scene, const RunOptions& options = {});

// All numbers of cables on the way down in one run: certified designs, the fewest cables first,
// each closer to the target than those with fewer; snapshots of the search are in the one that is
// asked for. Never empty.
core::Expected<std::vector<model::Design>> trade_off(const model::Scene& scene,
                                                     const RunOptions& options = {});

// What settings ask for, every_number apart.
model::Goal goal_of(const model::DesignSettings& settings);

// The design that answers the goal, among those of a trade-off, which are not empty.
const model::Design& best_for(const model::Goal& goal, std::span<const model::Design> designs);

}  // namespace tencer::pipeline
