// The scene file, TOML: targets, rods, supports and how to design. docs/scene.md describes it.
#pragma once

#include <filesystem>
#include <tencer/core/error.hpp>
#include <tencer/geometry/polyline.hpp>
#include <tencer/model/scene.hpp>
#include <vector>

namespace tencer::io {

// Reads a TOML scene and the curve files it names (relative to its folder). All indices, ranges and
// sizes are valid in what it returns. Errors: "file:line", with the key; an unknown key is one and
// comes with the key that is probably meant, or those known there.
core::Expected<model::Scene> read_scene(const std::filesystem::path& path);

// The scene of bare curves (as from read_curves) with every default. `source` is the curves' file:
// errors begin with it, and the scene is named after it.
core::Expected<model::Scene> scene_of_curves(const std::vector<geometry::Polyline>& curves,
                                             const std::filesystem::path& source);

}  // namespace tencer::io
