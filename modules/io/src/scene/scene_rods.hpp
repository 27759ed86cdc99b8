// The [[rod]] tables of a scene.
#pragma once

#include <filesystem>
#include <tencer/io/scene.hpp>

#include "scene/toml_value.hpp"

namespace tencer::io {

// Sets the scene's rods, and their weights as line loads when there is gravity (m/s^2). The scene's
// units are known; `material` is that of rods that say none.
void read_rods(const TomlTable& root, const std::filesystem::path& folder,
               const Eigen::Vector3d& gravity, const model::Material& material,
               model::Scene& scene);

}  // namespace tencer::io
