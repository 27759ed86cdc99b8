#include "scene_input.hpp"

#include <tencer/io/curve.hpp>
#include <utility>

namespace tencer::app {

core::Expected<model::Scene> read_scene_or_curve(const std::filesystem::path& input) {
  if (input.extension() == ".toml") return io::read_scene(input);
  auto curves = io::read_curves(input);
  if (!curves) return curves.error();
  return io::scene_of_curves(std::move(*curves), input);
}

}  // namespace tencer::app
