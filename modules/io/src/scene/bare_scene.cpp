// Scenes of files that hold rods but say nothing of how to design.
#include <tencer/io/curve.hpp>
#include <tencer/io/scene.hpp>
#include <tencer/model/redesign.hpp>
#include <utility>

#include "curves/curve_format.hpp"
#include "curves/round_curve.hpp"
#include "design/design_json.hpp"
#include "design/published_json.hpp"
#include "scene/parse_scene.hpp"
#include "scene/scene_keys.hpp"
#include "scene/vertex_limit.hpp"
#include "text/bad_input.hpp"
#include "text/read_text.hpp"

namespace tencer::io {
namespace {

using model::Scene;

void check_crossings(const Scene& scene) {
  if (const auto crossing = model::crossing(scene))
    fail(scene.source,
         *crossing +
             (are_flat(scene.target.points) ? ", such as in z, which is the same all over" : ""));
}

std::string words_for(const std::string& unit) {
  return unit == "in" ? "inches" : unit == "ft" ? "feet" : unit;
}

void refuse_curve_options(const std::filesystem::path& path, const SceneOptions& options) {
  if (options.close || options.length_unit || options.force_unit)
    fail(shown(path),
         std::string("says itself which curves are closed and in which units it is; ") +
             (options.close ? "--closed" : "--unit") + " is for bare curves: leave it out");
}

Scene scene_of_design(const nlohmann::json& content, const std::filesystem::path& path,
                      const SceneOptions& options) {
  refuse_curve_options(path, options);
  if (options.smooth)
    fail(shown(path), "is a design, whose rods are as they are: leave out --smooth");
  Scene scene =
      model::scene_of(any_design(JsonValue(content, shown(path)), path), options.material);
  scene.source = shown(path);
  scene.notes.emplace_back(
      "the file is a design: cables are designed anew for its target; --from goes on from its own");
  long vertices = 0;
  for (const Eigen::Matrix3Xd& points : scene.target.points) vertices += points.cols();
  if (vertices > most_vertices)
    fail(shown(path), "has rods of " + std::to_string(vertices) + " vertices, more than " +
                          std::to_string(most_vertices));
  check_crossings(scene);
  return scene;
}

Scene scene_of(CurveFile file, const std::filesystem::path& path, const SceneOptions& options) {
  for (geometry::Polyline& curve : file.curves)
    if (options.close)
      if (const auto problem = close_curve(curve)) fail(shown(path), "to be closed: " + *problem);
  if (!options.close)
    file.notes.insert(file.notes.end(), file.open_ends.begin(), file.open_ends.end());
  if (file.length_unit && !options.length_unit)
    file.notes.push_back("the file says that its numbers are " + words_for(*file.length_unit));
  if (const auto said = options.length_unit ? options.length_unit : file.length_unit)
    take_unit(file, *said);
  limit_vertices(file.curves, shown(path), file.notes);
  const std::string unit = file.length_unit.value_or(Scene().length_unit);
  for (geometry::Polyline& curve : file.curves)
    if (options.smooth)
      if (const auto problem = round_curve(*options.smooth, {}, unit, curve, file.notes))
        fail(shown(path), "--smooth: " + *problem);
  Scene scene = model::scene_of(file.curves, stem(path), unit,
                                options.force_unit.value_or(Scene().force_unit), options.material);
  scene.source = shown(path);
  scene.notes = std::move(file.notes);
  check_crossings(scene);
  return scene;
}

// What comes through a pipe has no name to tell.
bool is_scene(const std::filesystem::path& path, std::string_view text) {
  return path == "-" ? text.find("[[rod]]") != std::string_view::npos : path.extension() == ".toml";
}

// What a file holds that rods are in, given to the one that reads such.
template <class Scenes, class Designs, class Curves>
Scene read_any(const std::filesystem::path& path, Scenes&& scenes, Designs&& designs,
               Curves&& curves) {
  const std::string text = read_text(path);
  if (is_scene(path, text)) return scenes(text);
  if (format_of(path, text, shown(path)) == CurveFormat::json) {
    const nlohmann::json content = JsonValue::parse(text, shown(path));
    if (is_design(content)) return designs(content);
  }
  return curves(parse_curves(path, text, shown(path)));
}

}  // namespace

core::Expected<Scene> read_any_scene(const std::filesystem::path& path,
                                     const SceneOptions& options) {
  return guarded([&] {
    return read_any(
        path,
        [&](const std::string& text) {
          refuse_curve_options(path, options);
          return parse_scene(text, path, options);
        },
        [&](const nlohmann::json& content) { return scene_of_design(content, path, options); },
        [&](CurveFile file) { return scene_of(std::move(file), path, options); });
  });
}

core::Expected<Scene> scene_with_keys(const std::filesystem::path& path, const SceneKeys& keys) {
  return guarded([&] {
    SortedKeys said = sorted_keys(keys.text);
    SceneSource source = source_of(path, {});
    source.designs = keys.designs;
    return read_any(
        path,
        [&](const std::string& text) {
          source.rods.curves = keys.curves;
          toml::table root = TomlTable::parse(text, shown(path));
          take_keys(std::move(said), root);
          return read_root(TomlTable(root), source);
        },
        [&](const nlohmann::json& content) {
          Scene scene = scene_of_design(content, path, {});
          read_keys_beside_rods(said, source, scene);
          return scene;
        },
        [&](CurveFile file) { return scene_of_bare(std::move(file), std::move(said), source); });
  });
}

core::Expected<Scene> scene_of_curves(const std::vector<geometry::Polyline>& curves,
                                      const std::filesystem::path& source) {
  if (curves.empty()) return core::Error{source.string(), "holds no curves"};
  return guarded([&] { return scene_of({.curves = curves}, source, {}); });
}

}  // namespace tencer::io
