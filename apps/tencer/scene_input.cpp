#include "scene_input.hpp"

#include <tencer/io/curve.hpp>
#include <tencer/io/scene.hpp>
#include <tencer/model/resolution.hpp>

#include "command.hpp"

namespace tencer::app {
namespace {

core::Expected<model::Scene> read_scene_or_curve(const std::filesystem::path& input,
                                                 const io::SceneOptions& options) {
  if (input.extension() == ".toml" && options.close)
    return core::Error{"--closed", "is for bare curves; in a scene say closed = true of the rod"};
  if (input.extension() == ".toml") return io::read_scene(input, options);
  const auto file = io::read_curve_file(input);
  if (!file) return file.error();
  return io::scene_of_file(*file, input, options);
}

}  // namespace

void add_scene(CLI::App& command, SceneRequest& request, const std::string& cables) {
  command.add_option("INPUT", request.input, "Scene (.toml) or target curve")->required();
  add_material(command, request.material);
  command.add_flag("--closed", request.closed,
                   "The curves are closed, though their last points do not repeat the first");
  command
      .add_option("--max-error", request.max_error,
                  "Largest distance to the target, % of its bounding-box diagonal [the scene's, "
                  "else 1]")
      ->check(positive_number());
  command.add_option("--cables", request.cables, cables)->check(positive_integer());
  command
      .add_option("--resolution", request.resolution,
                  "Vertices of every rod, times what the scene has")
      ->check(positive_number())
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str();
}

core::Expected<model::Scene> requested_scene(const SceneRequest& request) {
  auto scene = read_scene_or_curve(
      request.input,
      {.material = *model::find_material(request.material), .close = request.closed});
  if (!scene) return scene.error();
  if (request.max_error) {
    scene->design.max_error = *request.max_error;
    scene->design.cables.reset();
  }
  if (request.cables) scene->design.cables = request.cables;
  return model::at_resolution(*scene, request.resolution);
}

}  // namespace tencer::app
