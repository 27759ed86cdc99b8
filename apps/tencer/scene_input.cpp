#include "scene_input.hpp"

#include <tencer/io/curve.hpp>
#include <tencer/io/scene.hpp>
#include <tencer/model/resolution.hpp>
#include <vector>

#include "command.hpp"

namespace tencer::app {

void add_scene(CLI::App& command, SceneRequest& request, const std::string& cables) {
  command.add_option("INPUT", request.input, "Scene (.toml), target curve or design; - is stdin")
      ->required();
  add_material(command, request.material);
  command.add_flag("--closed", request.closed,
                   "The curves are closed, though their last points do not repeat the first");
  const auto units = io::curve_units();
  command
      .add_option("--unit", request.unit,
                  "Of the curve's numbers: mm, cm, m, in or ft [the file's, else cm]")
      ->check(one_of({units.begin(), units.end()}));
  command
      .add_option("--smooth", request.smooth,
                  "Round bends sharper than this radius to it, in the scene's unit of length [the "
                  "scene's, else they stay]")
      ->check(positive_number());
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
  auto scene =
      io::read_any_scene(request.input, {.material = *model::find_material(request.material),
                                         .close = request.closed,
                                         .length_unit = request.unit,
                                         .smooth = request.smooth});
  if (!scene) return scene.error();
  if (request.max_error) {
    scene->design.max_error = *request.max_error;
    scene->design.cables.reset();
  }
  if (request.cables) scene->design.cables = request.cables;
  return model::at_resolution(*scene, request.resolution);
}

}  // namespace tencer::app
