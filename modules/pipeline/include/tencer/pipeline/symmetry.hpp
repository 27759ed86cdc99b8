// The symmetries that a scene's cables are to keep: given in the scene, or found.
#pragma once

#include <optional>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/io/scene.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/symmetry/detect.hpp>

namespace tencer::pipeline {

// As design.symmetry says: those that are given, each checked against the targets; or those found;
// none for "none" and "offer", or when there are none but the identity. They map not only the rods
// and anchors onto themselves, but also sections, pins, loads, weights and what the scene allows of
// cables; scaled. Errors name the scene's file and the generator, and say by how much it misses.
// Reads all of `prepared` but its symmetry and parts.
core::Expected<std::optional<symmetry::Group>> symmetry_of(const io::Scene& scene,
                                                           const Prepared& prepared);

// What the target nearly has, to a hundredth of its bounding box's diagonal; at least the identity.
symmetry::Group near_symmetry(const Prepared& prepared);

// What detect finds in words, such as "a 3-fold rotation about (0, 0, 1) and a mirror plane
// across (1, 0, 0)"; empty when the target has no symmetry.
std::string symmetry_in_words(const Prepared& prepared);

}  // namespace tencer::pipeline
