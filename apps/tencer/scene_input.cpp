#include "scene_input.hpp"

#include <tencer/io/curve.hpp>

namespace tencer::app {

core::Expected<model::Scene> read_scene_or_curve(const std::filesystem::path& input,
                                                 const io::SceneOptions& options) {
  if (input.extension() == ".toml" && options.close)
    return core::Error{"--closed", "is for bare curves; in a scene say closed = true of the rod"};
  if (input.extension() == ".toml") return io::read_scene(input, options);
  const auto file = io::read_curve_file(input);
  if (!file) return file.error();
  return io::scene_of_file(*file, input, options);
}

}  // namespace tencer::app
