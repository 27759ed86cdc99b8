// The symmetries that a scene's cables are to keep: given in the scene, or found.
#pragma once

#include <optional>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/ground_structure/problem.hpp>
#include <tencer/model/scaling.hpp>
#include <tencer/model/scene.hpp>

namespace tencer::pipeline {

// As scene.design.symmetry says: those that are given, each checked against the targets; or those
// found; none for `none` and `suggest`, or when there are none but the identity. They map not only
// the rods and anchors onto themselves, but also sections, pins, loads, weights and what the rules
// allow of cables; scaled. Errors name the scene's source and the generator, and say by how much it
// misses. problem: of the scene; its candidates and symmetry are not looked at.
core::Expected<std::optional<symmetry::Group>> symmetry_of(const model::Scene& scene,
                                                           const ground_structure::Problem& problem,
                                                           const model::Scaling& scaling);

// The target's symmetries in words, such as "a 3-fold rotation about (0, 0, 1) and a mirror plane
// across (1, 0, 0)"; empty when it has none.
std::string symmetry_in_words(const ground_structure::Problem& problem);

}  // namespace tencer::pipeline
