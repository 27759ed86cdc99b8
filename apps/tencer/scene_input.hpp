// What commands that design take: scenes, or bare curves with every default.
#pragma once

#include <filesystem>
#include <tencer/core/error.hpp>
#include <tencer/io/scene.hpp>

namespace tencer::app {

// A scene (.toml), or the scene of a curve file.
core::Expected<model::Scene> read_scene_or_curve(const std::filesystem::path& input,
                                                 const io::SceneOptions& options);

}  // namespace tencer::app
