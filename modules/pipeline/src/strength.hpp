// Whether the rods can be bent to the target at all, and for long.
#pragma once

#include <optional>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/model/scene.hpp>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::pipeline {

// A rod that is thicker than its bend is wide: a radius of curvature below the section's own half
// size. `start` is the rods at the target, scaled so that lengths are multiples of `unit`.
std::optional<core::Error> check_bends(const model::Scene& scene, const model::Structure& structure,
                                       const model::State& start, double unit);

// Corners, roughness, and strains that the rods' materials do not hold for long, in words.
std::vector<std::string> bend_warnings(const model::Scene& scene, const model::Structure& structure,
                                       const model::State& start, double unit);

}  // namespace tencer::pipeline
