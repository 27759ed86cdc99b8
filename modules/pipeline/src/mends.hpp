// What might make a scene feasible that is not: each change is tried, none is guessed.
#pragma once

#include <functional>
#include <optional>
#include <tencer/model/feasibility.hpp>
#include <tencer/model/scene.hpp>
#include <vector>

namespace tencer::pipeline {

// How far the rods of a scene rest from their target with all cables tied, in %; none: the scene is
// not a task.
using Trial = std::function<std::optional<double>(const model::Scene&)>;

// The changes that make sense for the scene, with what came of each: rules lifted one by one, a
// frame with anchors about the rods, the plane taken as given, the curves smoothed more and more.
std::vector<model::Mend> try_mends(const model::Scene& scene, const Trial& trial);

}  // namespace tencer::pipeline
