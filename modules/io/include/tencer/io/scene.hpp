// The scene file, TOML: targets, rods, supports and how to design. docs/scene.md describes it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
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
  // Of the numbers of bare files, one of curve_units(), whatever they say themselves.
  std::optional<std::string> length_unit{};
  std::optional<std::string> force_unit{};  // of bare files, N by default
  // The radius to which bends of all curves are rounded, in the scene's unit; not set: as rods say.
  std::optional<double> smooth{};
};

// Keys of docs/scene.md that a program says, in place of a file's or without one. The keys of
// [design] and [[rod]] stand beside those of the top level (`max_error = 0.5`,
// `section = {radius = 0.1}`), as no two have the same name; those of [[rod]] are of every rod, but
// for what a table of `rod` (`rod = [{curve = 0}]`) says itself. [build] and [edit] are tables
// (`build = {length_error = 0}`).
//
// What is said of curves and designs in memory is their number in place of a file's name: `curve`
// and `edit.from` count from 0. Paths are relative to the file's folder.
struct SceneKeys {
  std::string text{};  // TOML
  std::vector<geometry::Polyline> curves{};
  std::vector<model::Design> designs{};
};

// Reads a TOML scene and the curve files it names (relative to its folder). All indices, ranges and
// sizes are valid in what it returns. Errors: "file:line", with the key; an unknown key is one and
// comes with the key that is probably meant, or those known there.
core::Expected<model::Scene> read_scene(const std::filesystem::path& path,
                                        const SceneOptions& options = {});

// What there is to design in any file that holds rods: a scene (.toml); a design, or a published
// model of the paper (design.hpp), without its cables; or curves, with every default. Options for
// bare files are an error with the others.
core::Expected<model::Scene> read_any_scene(const std::filesystem::path& path,
                                            const SceneOptions& options = {});

// The scene of such a file with keys in place of what it says. A max_error takes the place of the
// file's number of cables, too. Of a design the rods are as they are: keys of [[rod]] are an error.
// Errors in keys name the key alone.
core::Expected<model::Scene> scene_with_keys(const std::filesystem::path& path,
                                             const SceneKeys& keys);

// The scene of the keys alone, called `name` if they say no other. Its rods are those of `rod`, or
// without that what `family`, `spline` or `curve` says.
core::Expected<model::Scene> scene_of_keys(const SceneKeys& keys, const std::string& name);

// The scene of curves with every default. `source` is where they came from: errors begin with it,
// and the scene is named after it.
core::Expected<model::Scene> scene_of_curves(const std::vector<geometry::Polyline>& curves,
                                             const std::filesystem::path& source);

}  // namespace tencer::io
