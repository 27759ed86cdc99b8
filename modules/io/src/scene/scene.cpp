#include <algorithm>
#include <array>
#include <functional>
#include <tencer/core/names.hpp>
#include <tencer/geometry/frame.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/geometry/sampling.hpp>
#include <tencer/io/scene.hpp>
#include <tencer/model/units.hpp>
#include <utility>

#include "scene/parse_scene.hpp"
#include "scene/scene_edit.hpp"
#include "scene/scene_rods.hpp"
#include "scene/scene_section.hpp"
#include "scene/scene_views.hpp"
#include "scene/toml_value.hpp"
#include "text/bad_input.hpp"
#include "text/read_text.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

using geometry::Polyline;
using model::Scene;

// ---- what refers to rods

int rod_index(const TomlTable& table, const Scene& scene) {
  const int rod = table.need("rod", table.integer("rod", 0));
  const int rods = static_cast<int>(scene.structure.rods.size());
  if (rod >= rods)
    table.fail("rod", "there is no rod " + std::to_string(rod) + "; " + index_range(rods));
  return rod;
}

void check_vertex(const TomlTable& table, std::string_view key, int vertex, const der::Rod& rod) {
  if (vertex >= rod.vertices())
    table.fail(key,
               "there is no vertex " + std::to_string(vertex) + "; " + index_range(rod.vertices()));
}

model::Pin read_pin(const TomlTable& table, const Scene& scene) {
  table.only({"rod", "vertex", "axes"});
  model::Pin pin;
  pin.rod = rod_index(table, scene);
  pin.vertex = table.need("vertex", table.integer("vertex", 0));
  check_vertex(table, "vertex", pin.vertex, scene.structure.rods[pin.rod]);
  const std::string axes = table.text("axes").value_or("xyz");
  if (axes.empty() || axes.find_first_not_of("xyz") != std::string::npos)
    table.fail("axes", "expected letters of \"xyz\", found \"" + axes + "\"");
  for (std::size_t axis = 0; axis < 3; ++axis)
    pin.axes[axis] = axes.find("xyz"[axis]) != std::string::npos;
  return pin;
}

model::PointLoad read_load(const TomlTable& table, const Scene& scene) {
  table.only({"rod", "s", "force"});
  model::PointLoad load;
  load.rod = rod_index(table, scene);
  load.s = table.need("s", table.at_least_zero("s"));
  const double length = scene.structure.rods[load.rod].length();
  if (load.s > length) table.fail("s", "expected an arc length from 0 to " + to_text(length));
  load.force = table.need("force", table.point("force"));
  return load;
}

model::Arc read_arc(const TomlTable& table, const Scene& scene) {
  const int r = rod_index(table, scene);
  const der::Rod& rod = scene.structure.rods[r];
  const double length = rod.length();
  const auto bound = [&](std::string_view key) {
    const double s = table.need(key, table.at_least_zero(key));
    if (s > length) table.fail(key, "expected an arc length from 0 to " + to_text(length));
    return s;
  };
  const model::Arc arc{.rod = r, .from = bound("from"), .to = bound("to")};
  if (!rod.closed && arc.from > arc.to)
    table.fail("from", "must not be larger than to on an open rod");
  return arc;
}

bool contains(const model::Arc& arc, double s) {
  return arc.from <= arc.to ? s >= arc.from && s <= arc.to : s >= arc.from || s <= arc.to;
}

geometry::ArcLength arc_length(const Scene& scene, int rod) {
  return {scene.structure.rods[rod].rest_lengths, scene.structure.rods[rod].closed};
}

void read_weights(const TomlTable& design, Scene& scene) {
  for (const TomlTable& table : design.tables("weights")) {
    table.only({"rod", "from", "to", "weight"});
    const int r = rod_index(table, scene);
    const model::Arc arc =
        table.has("from") || table.has("to")
            ? read_arc(table, scene)
            : model::Arc{.rod = r, .from = 0.0, .to = scene.structure.rods[r].length()};
    const double weight = table.need("weight", table.at_least_zero("weight"));
    const geometry::ArcLength positions = arc_length(scene, r);
    Eigen::VectorXd& weights = scene.target.weights[r];
    for (Eigen::Index i = 0; i < weights.size(); ++i)
      if (contains(arc, positions.knots()[i])) weights[i] = weight;
  }
  const bool some = std::ranges::any_of(
      scene.target.weights, [](const Eigen::VectorXd& weights) { return weights.maxCoeff() > 0; });
  if (!some) design.fail("weights", "all vertices have weight 0; leave some to be matched");
}

void read_forbidden(const TomlTable& design, Scene& scene) {
  auto& forbidden = scene.rules.forbidden;
  for (const TomlTable& table : design.tables("forbidden_arcs")) {
    table.only({"rod", "from", "to"});
    forbidden.push_back(read_arc(table, scene));
  }
  for (const TomlTable& table : design.tables("forbidden_vertices")) {
    table.only({"rod", "vertices"});
    const int r = rod_index(table, scene);
    const geometry::ArcLength positions = arc_length(scene, r);
    for (const int vertex : table.need("vertices", table.integers("vertices"))) {
      check_vertex(table, "vertices", vertex, scene.structure.rods[r]);
      const double s = positions.knots()[vertex];
      forbidden.push_back({.rod = r, .from = s, .to = s});
    }
  }
}

void read_rod_pairs(const TomlTable& design, Scene& scene) {
  const auto lists = design.integer_lists("rod_pairs");
  if (!lists) return;
  const int rods = static_cast<int>(scene.structure.rods.size());
  std::vector<model::RodPair> pairs;
  for (const std::vector<int>& list : *lists) {
    if (list.size() != 2)
      design.fail("rod_pairs",
                  "expected pairs [a, b], found an array of " + std::to_string(list.size()));
    for (const int rod : list)
      if (rod >= rods)
        design.fail("rod_pairs",
                    "there is no rod " + std::to_string(rod) + "; " + index_range(rods));
    pairs.push_back({std::min(list[0], list[1]), std::max(list[0], list[1])});
  }
  if (pairs.empty() && (scene.structure.anchors.cols() == 0 || !scene.rules.external))
    design.fail("rod_pairs",
                "is empty and there are no cables to anchors, so no cable is left; "
                "name a pair of rods, such as [0, 0] for cables within rod 0");
  scene.rules.pairs = std::move(pairs);
}

model::SymmetryGenerator read_generator(const TomlTable& table) {
  table.only({"fold", "axis", "normal", "point"});
  const auto direction = [&](std::string_view key) {
    const Eigen::Vector3d value = table.need(key, table.point(key));
    if (!(value.norm() > 0)) table.fail(key, "must not be zero: it has no direction");
    return value;
  };
  if (table.has("normal")) {
    for (const std::string_view key : {"fold", "axis"})
      if (table.has(key))
        table.fail(key, "is of a rotation, normal of a reflection; make them two tables");
    return model::Reflection{.normal = direction("normal"), .point = table.point("point")};
  }
  constexpr int max_fold = 240;
  return model::Rotation{.fold = table.need("fold", table.integer("fold", 2, max_fold)),
                         .axis = direction("axis"),
                         .point = table.point("point")};
}

// The value that a key names; the present one when the key is not there.
template <class Enum>
void choose(const TomlTable& design, std::string_view key, std::span<const Enum> allowed,
            Enum& value) {
  std::vector<std::string_view> names;
  for (const Enum choice : allowed) names.push_back(model::name_of(choice));
  if (const auto name = design.one_of(key, names)) value = *model::named<Enum>(*name);
}

template <class Enum>
void choose(const TomlTable& design, std::string_view key, Enum& value) {
  std::vector<Enum> all;
  for (const auto& [choice, name] : model::names<Enum>()) all.push_back(choice);
  choose<Enum>(design, key, all, value);
}

void read_symmetry(const TomlTable& design, Scene& scene) {
  using model::SymmetryUse;
  if (!design.is_array("symmetry")) {
    constexpr std::array words{SymmetryUse::none, SymmetryUse::suggest, SymmetryUse::detect};
    choose<SymmetryUse>(design, "symmetry", words, scene.design.symmetry);
    return;
  }
  scene.design.symmetry = SymmetryUse::given;
  for (const TomlTable& table : design.tables("symmetry"))
    scene.generators.push_back(read_generator(table));
}

void read_optimizer(const TomlTable& design, model::DesignSettings& settings) {
  choose(design, "optimizer", settings.optimizer);
  choose(design, "hessian", settings.hessian);
  if (design.has("hessian"))
    if (const auto problem = model::hessian_problem(settings.optimizer, settings.hessian))
      design.fail("hessian", *problem);
}

void read_hand_over(const TomlTable& design, Scene& scene) {
  scene.design.hand_over = design.boolean("hand_over").value_or(scene.design.hand_over);
  if (!scene.design.hand_over) return;
  if (scene.structure.pins.empty())
    design.fail("hand_over", "is true, but the scene has no pinned vertices to hand over");
  if (scene.structure.anchors.cols() == 0)
    design.fail("hand_over",
                "is true, but the scene has no anchors to hand its pins over to; add anchors = "
                "[[x, y, z], ...] or frame = {shape = \"cube\"}");
}

void read_external(const TomlTable& design, Scene& scene) {
  scene.rules.external = design.boolean("external").value_or(scene.rules.external);
  if (design.has("external") && scene.rules.external && scene.structure.anchors.cols() == 0)
    design.fail("external",
                "is true, but the scene has no anchors; add anchors = [[x, y, z], ...] or "
                "frame = {shape = \"cube\"}");
}

void read_design_settings(const TomlTable& design, Scene& scene) {
  design.only(design_keys);
  model::DesignSettings& settings = scene.design;
  const auto positive = [&](std::string_view key, double& value) {
    value = design.positive(key).value_or(value);
  };
  choose(design, "method", settings.method);
  choose(design, "objective", settings.objective);
  read_symmetry(design, scene);
  read_optimizer(design, settings);
  positive("max_error", settings.max_error);
  settings.cables = design.integer("cables", 1);
  positive("longest_cable", scene.rules.max_cable_length);
  settings.threads = design.integer("threads", 1);
  settings.time = design.positive("time");
  settings.effort = design.integer("effort", 1, 3).value_or(settings.effort);
  positive("spring_stiffness", settings.spring_stiffness);
  positive("greedy_threshold", settings.greedy_threshold);
  settings.sparsity_weights =
      design.numbers("sparsity_weights").value_or(settings.sparsity_weights);
  const auto& weights = settings.sparsity_weights;
  if (weights.empty() || weights[0] < 0 ||
      std::ranges::adjacent_find(weights, std::greater_equal{}) != weights.end())
    design.fail("sparsity_weights", "expected increasing numbers that are not negative");
  read_external(design, scene);
  read_hand_over(design, scene);
  read_rod_pairs(design, scene);
  read_weights(design, scene);
  if (design.has("view")) scene.target.views = read_views(design, scene.structure.planar);
  read_forbidden(design, scene);
}

// A number, in %, or a text with its unit.
std::optional<model::Allowance> read_allowance(const TomlTable& table, std::string_view key) {
  if (!table.is_text(key)) {
    const auto percent = table.positive(key);
    return percent ? std::optional(model::Allowance{.amount = *percent}) : std::nullopt;
  }
  const std::string text = *table.text(key);
  auto allowance = model::read_allowance(text);
  if (!allowance)
    table.fail(key, "expected a number, in %, or a length such as \"2 mm\", found \"" + text + '"');
  return allowance;
}

void read_build(const TomlTable& build, model::BuildSettings& settings) {
  build.only({"length_error", "attachment_error", "max_deviation", "clearance", "mark_distance",
              "layers", "min_tension_ratio", "min_tension"});
  settings.length_error = build.at_least_zero("length_error");
  settings.attachment_error = build.at_least_zero("attachment_error");
  settings.max_deviation = read_allowance(build, "max_deviation");
  settings.clearance = build.at_least_zero("clearance");
  settings.mark_distance = build.at_least_zero("mark_distance");
  settings.layers = build.boolean("layers").value_or(settings.layers);
  settings.min_tension_ratio =
      build.at_least_zero("min_tension_ratio").value_or(settings.min_tension_ratio);
  if (settings.min_tension_ratio >= 1) build.fail("min_tension_ratio", "must be less than 1");
  settings.min_tension = build.at_least_zero("min_tension");
}

// The corners of a frame about all targets.
Eigen::Matrix3Xd frame_anchors(const TomlTable& frame, const Scene& scene) {
  frame.only({"shape", "margin"});
  const std::string shape = frame.need(
      "shape", frame.one_of("shape", std::array<std::string_view, 2>{"cube", "tetrahedron"}));
  const std::vector<Polyline> targets = model::target_curves(scene);
  Eigen::Index vertices = 0;
  for (const Polyline& target : targets) vertices += target.points.cols();
  Eigen::Matrix3Xd points(3, vertices);
  for (Eigen::Index at = 0; const Polyline& target : targets) {
    points.middleCols(at, target.points.cols()) = target.points;
    at += target.points.cols();
  }
  constexpr double standard_margin = 0.1;  // of the bounding-box diagonal
  const double margin =
      frame.positive("margin").value_or(standard_margin * geometry::bounding_box_diagonal(targets));
  return geometry::enclosing_frame(
      shape == "cube" ? geometry::FrameShape::cube : geometry::FrameShape::tetrahedron, points,
      margin, scene.structure.planar);
}

// All z coordinates of a planar scene are the same.
void check_plane(const Scene& scene, const std::string& where) {
  constexpr double negligible_gap = 1e-9;  // relative to the bounding-box diagonal
  const auto curves = model::target_curves(scene);
  const double z = curves[0].points(2, 0);
  const double tolerance = negligible_gap * geometry::bounding_box_diagonal(curves);
  for (std::size_t r = 0; r < curves.size(); ++r)
    for (int i = 0; i < curves[r].vertices(); ++i)
      if (std::abs(curves[r].points(2, i) - z) > tolerance)
        fail(where, "planar: all z coordinates must be the same, but vertex 0 of " +
                        core::rod_in_words(0, curves.size()) + " has z = " + to_text(z) +
                        " and vertex " + std::to_string(i) + " of " +
                        core::rod_in_words(r, curves.size()) +
                        " has z = " + to_text(curves[r].points(2, i)));
  const Eigen::Matrix3Xd& anchors = scene.structure.anchors;
  for (Eigen::Index i = 0; i < anchors.cols(); ++i)
    if (std::abs(anchors(2, i) - z) > tolerance)
      fail(where,
           "planar: all z coordinates must be the same, but the rods have z = " + to_text(z) +
               " and anchors[" + std::to_string(i) + "] has z = " + to_text(anchors(2, i)));
}

}  // namespace

void read_task(const TomlTable& root, const SceneSource& source, Scene& scene) {
  model::Structure& structure = scene.structure;
  structure.planar = root.boolean("planar").value_or(structure.planar);
  scene.target.planar = structure.planar;
  structure.anchors = root.points("anchors").value_or(structure.anchors);
  if (const auto frame = root.table("frame")) {
    if (root.has("anchors"))
      root.fail("frame", "its corners are the anchors; give either frame or anchors");
    structure.anchors = frame_anchors(*frame, scene);
  }
  for (const TomlTable& pin : root.tables("pinned")) structure.pins.push_back(read_pin(pin, scene));
  for (const TomlTable& load : root.tables("loads"))
    structure.point_loads.push_back(read_load(load, scene));
  if (const auto design = root.table("design")) read_design_settings(*design, scene);
  if (const auto build = root.table("build")) read_build(*build, scene.build);
  if (const auto edit = root.table("edit"))
    scene.edit = read_edit(*edit, source.rods.folder, source.designs);
  if (const auto crossing = model::crossing(scene)) fail(scene.source, *crossing);
  if (structure.planar) check_plane(scene, root.where("planar"));
}

Scene read_root(const TomlTable& root, const SceneSource& source) {
  root.only(root_keys);
  Scene scene;
  scene.name = root.text("name").value_or(source.name);
  scene.source = source.shown;
  scene.length_unit = root.one_of("length_unit", model::length_units()).value_or(scene.length_unit);
  scene.force_unit = root.one_of("force_unit", model::force_units()).value_or(scene.force_unit);
  read_rods(root, source.rods, root.point("gravity").value_or(Eigen::Vector3d::Zero()), scene);
  read_task(root, source, scene);
  return scene;
}

SceneSource source_of(const std::filesystem::path& path, const SceneOptions& options) {
  return {
      .name = stem(path),
      .shown = shown(path),
      .rods = {
          .folder = path.parent_path(), .material = options.material, .smooth = options.smooth}};
}

Scene parse_scene(std::string_view text, const std::filesystem::path& path,
                  const SceneOptions& options) {
  const toml::table content = TomlTable::parse(text, shown(path));
  return read_root(TomlTable(content), source_of(path, options));
}

core::Expected<Scene> read_scene(const std::filesystem::path& path, const SceneOptions& options) {
  return guarded([&] { return parse_scene(read_text(path), path, options); });
}

}  // namespace tencer::io
