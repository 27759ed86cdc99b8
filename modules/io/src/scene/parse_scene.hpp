// A scene from its text.
#pragma once

#include <filesystem>
#include <string_view>
#include <tencer/io/scene.hpp>

namespace tencer::io {

// Throws BadInput. Curve files are relative to the folder of `path`, which names the scene.
model::Scene parse_scene(std::string_view text, const std::filesystem::path& path,
                         const SceneOptions& options);

}  // namespace tencer::io
