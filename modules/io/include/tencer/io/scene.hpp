// The scene file, TOML: targets, rods, supports and how to design. docs/scene.md describes it.
#pragma once

#include <filesystem>
#include <tencer/core/error.hpp>
#include <tencer/geometry/polyline.hpp>
#include <tencer/io/curve.hpp>
#include <tencer/model/scene.hpp>
#include <vector>

namespace tencer::io {

// What is taken where neither the scene nor the rod says it.
struct SceneOptions {
  model::Material material = model::glass_fibre();
  bool close = false;  // curves of bare files (close_curve)
};

// Reads a TOML scene and the curve files it names (relative to its folder). All indices, ranges and
// sizes are valid in what it returns. Errors: "file:line", with the key; an unknown key is one and
// comes with the key that is probably meant, or those known there.
core::Expected<model::Scene> read_scene(const std::filesystem::path& path,
                                        const SceneOptions& options = {});

// The scene of a curve file with every default, in the unit that the file names. `source` is the
// file: errors begin with it, and the scene is named after it.
core::Expected<model::Scene> scene_of_file(const CurveFile& file,
                                           const std::filesystem::path& source,
                                           const SceneOptions& options = {});

// Likewise of its curves alone.
core::Expected<model::Scene> scene_of_curves(const std::vector<geometry::Polyline>& curves,
                                             const std::filesystem::path& source);

}  // namespace tencer::io
