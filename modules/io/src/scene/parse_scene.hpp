// A scene from its text, or from the table that the text is of.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <tencer/io/scene.hpp>

#include "scene/scene_rods.hpp"
#include "scene/toml_value.hpp"

namespace tencer::io {

inline constexpr std::array<std::string_view, 13> root_keys{
    "name",    "length_unit", "force_unit", "planar", "anchors", "frame", "pinned",
    "gravity", "loads",       "rod",        "design", "build",   "edit"};
inline constexpr std::array<std::string_view, 21> design_keys{"method",
                                                              "optimizer",
                                                              "hessian",
                                                              "max_error",
                                                              "cables",
                                                              "objective",
                                                              "symmetry",
                                                              "rod_pairs",
                                                              "external",
                                                              "hand_over",
                                                              "longest_cable",
                                                              "weights",
                                                              "view",
                                                              "forbidden_arcs",
                                                              "forbidden_vertices",
                                                              "sparsity_weights",
                                                              "spring_stiffness",
                                                              "greedy_threshold",
                                                              "threads",
                                                              "time",
                                                              "effort"};

// Whose keys they are, and what they may refer to.
struct SceneSource {
  std::string name{};   // of a scene that says none
  std::string shown{};  // in front of errors
  RodSource rods{};
  std::span<const model::Design> designs{};  // that `edit` names by number
};

// All below throw BadInput.

// Curve files are relative to the folder of `path`, which names the scene.
model::Scene parse_scene(std::string_view text, const std::filesystem::path& path,
                         const SceneOptions& options);

SceneSource source_of(const std::filesystem::path& path, const SceneOptions& options);
model::Scene read_root(const TomlTable& root, const SceneSource& source);

// What the table says beside rods and units, in place of what the scene says.
void read_task(const TomlTable& root, const SceneSource& source, model::Scene& scene);

}  // namespace tencer::io
