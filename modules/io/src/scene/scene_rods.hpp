// The [[rod]] tables of a scene.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <tencer/io/scene.hpp>

#include "scene/toml_value.hpp"

namespace tencer::io {

inline constexpr std::array<std::string_view, 13> rod_keys{
    "curve",  "index",   "family",   "parameters", "spline", "vertices",     "smooth",
    "closed", "section", "material", "director",   "rest",   "closing_turns"};

// Where the curves of rods come from, what rods that say no material are made of, and the radius to
// which the bends of all are rounded, whatever they say.
struct RodSource {
  std::filesystem::path folder{};
  std::span<const geometry::Polyline> curves{};  // that a rod names by number
  model::Material material{};
  std::optional<double> smooth{};
};

// Sets the scene's rods, and their weights as line loads when there is gravity (m/s^2). The scene's
// units are known.
void read_rods(const TomlTable& root, const RodSource& source, const Eigen::Vector3d& gravity,
               model::Scene& scene);

}  // namespace tencer::io
