// What of a target does not do for rods that are to be built.
#pragma once

#include <string>
#include <tencer/model/scene.hpp>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::pipeline {

// Bends that are too tight (strength.hpp), and for each pair of rods, of a rod and itself as well,
// places nearer to each other than the rods are thick, in words. `start` is the rods at the target,
// scaled so that lengths are multiples of `unit`.
std::vector<std::string> target_warnings(const model::Scene& scene,
                                         const model::Structure& structure,
                                         const model::State& start, double unit);

}  // namespace tencer::pipeline
