#include <algorithm>
#include <array>
#include <functional>
#include <tencer/geometry/frame.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/geometry/sampling.hpp>
#include <tencer/io/curve.hpp>
#include <tencer/io/file.hpp>
#include <tencer/io/scene.hpp>
#include <utility>

#include "bad_input.hpp"
#include "scene_rods.hpp"
#include "scene_section.hpp"
#include "scene_targets.hpp"
#include "scene_units.hpp"
#include "text.hpp"
#include "toml_value.hpp"

namespace tencer::io {
namespace {

using geometry::Polyline;

// ---- what refers to rods

int rod_index(const TomlTable& table, const Scene& scene) {
  const int rod = table.need("rod", table.integer("rod", 0));
  const int rods = static_cast<int>(scene.rods.size());
  if (rod >= rods)
    table.fail("rod", "there is no rod " + std::to_string(rod) + "; " + index_range(rods));
  return rod;
}

void check_vertex(const TomlTable& table, std::string_view key, int vertex, const SceneRod& rod) {
  if (vertex >= rod.target.vertices())
    table.fail(key, "there is no vertex " + std::to_string(vertex) + "; " +
                        index_range(rod.target.vertices()));
}

Pin read_pin(const TomlTable& table, const Scene& scene) {
  table.only({"rod", "vertex", "axes"});
  Pin pin;
  pin.rod = rod_index(table, scene);
  pin.vertex = table.need("vertex", table.integer("vertex", 0));
  check_vertex(table, "vertex", pin.vertex, scene.rods[pin.rod]);
  const std::string axes = table.text("axes").value_or("xyz");
  if (axes.empty() || axes.find_first_not_of("xyz") != std::string::npos)
    table.fail("axes", "expected letters of \"xyz\", found \"" + axes + "\"");
  for (std::size_t axis = 0; axis < 3; ++axis)
    pin.axes[axis] = axes.find("xyz"[axis]) != std::string::npos;
  return pin;
}

PointLoad read_load(const TomlTable& table, const Scene& scene) {
  table.only({"rod", "s", "force"});
  PointLoad load;
  load.rod = rod_index(table, scene);
  load.s = table.need("s", table.at_least_zero("s"));
  const double length = geometry::edge_lengths(scene.rods[load.rod].target).sum();
  if (load.s > length) table.fail("s", "expected an arc length from 0 to " + to_text(length));
  load.force = table.need("force", table.point("force"));
  return load;
}

Arc read_arc(const TomlTable& table, const SceneRod& rod) {
  const double length = geometry::edge_lengths(rod.target).sum();
  const auto bound = [&](std::string_view key) {
    const double s = table.need(key, table.at_least_zero(key));
    if (s > length) table.fail(key, "expected an arc length from 0 to " + to_text(length));
    return s;
  };
  const Arc arc{bound("from"), bound("to")};
  if (!rod.target.closed && arc.from > arc.to)
    table.fail("from", "must not be larger than to on an open rod");
  return arc;
}

bool contains(const Arc& arc, double s) {
  return arc.from <= arc.to ? s >= arc.from && s <= arc.to : s >= arc.from || s <= arc.to;
}

void read_weights(const TomlTable& design, Scene& scene) {
  for (const TomlTable& table : design.tables("weights")) {
    table.only({"rod", "from", "to", "weight"});
    SceneRod& rod = scene.rods[rod_index(table, scene)];
    const Arc arc = table.has("from") || table.has("to")
                        ? read_arc(table, rod)
                        : Arc{0.0, geometry::edge_lengths(rod.target).sum()};
    const double weight = table.need("weight", table.at_least_zero("weight"));
    const geometry::ArcLength positions = geometry::arc_length(rod.target);
    for (int i = 0; i < rod.target.vertices(); ++i)
      if (contains(arc, positions.knots()[i])) rod.weights[i] = weight;
  }
  const bool some = std::ranges::any_of(
      scene.rods, [](const SceneRod& rod) { return rod.weights.maxCoeff() > 0; });
  if (!some) design.fail("weights", "all vertices have weight 0; leave some to be matched");
}

void read_forbidden(const TomlTable& design, Scene& scene) {
  for (const TomlTable& table : design.tables("forbidden_arcs")) {
    table.only({"rod", "from", "to"});
    SceneRod& rod = scene.rods[rod_index(table, scene)];
    rod.forbidden_arcs.push_back(read_arc(table, rod));
  }
  for (const TomlTable& table : design.tables("forbidden_vertices")) {
    table.only({"rod", "vertices"});
    SceneRod& rod = scene.rods[rod_index(table, scene)];
    for (const int vertex : table.need("vertices", table.integers("vertices"))) {
      check_vertex(table, "vertices", vertex, rod);
      rod.forbidden_vertices.push_back(vertex);
    }
  }
}

void read_rod_pairs(const TomlTable& design, Scene& scene) {
  const auto lists = design.integer_lists("rod_pairs");
  if (!lists) return;
  const int rods = static_cast<int>(scene.rods.size());
  std::vector<std::array<int, 2>> pairs;
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
  if (pairs.empty() && (scene.anchors.cols() == 0 || !scene.design.external))
    design.fail("rod_pairs",
                "is empty and there are no cables to anchors, so no cable is left; "
                "name a pair of rods, such as [0, 0] for cables within rod 0");
  scene.design.rod_pairs = std::move(pairs);
}

SymmetryGenerator read_generator(const TomlTable& table) {
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
    return Reflection{.normal = direction("normal"), .point = table.point("point")};
  }
  constexpr int most_folds = 240;
  return Rotation{.fold = table.need("fold", table.integer("fold", 2, most_folds)),
                  .axis = direction("axis"),
                  .point = table.point("point")};
}

void read_symmetry(const TomlTable& design, DesignSettings& settings) {
  if (!design.is_array("symmetry")) {
    constexpr std::array<std::string_view, 3> words{"none", "offer", "detect"};
    settings.symmetry = design.one_of("symmetry", words).value_or(settings.symmetry);
    return;
  }
  settings.symmetry = "given";
  for (const TomlTable& table : design.tables("symmetry"))
    settings.generators.push_back(read_generator(table));
}

void read_design(const TomlTable& design, Scene& scene) {
  design.only({"method", "optimizer", "hessian", "max_error", "cables", "objective", "symmetry",
               "rod_pairs", "external", "hand_over", "longest_cable", "weights", "forbidden_arcs",
               "forbidden_vertices", "sparsity_weights", "spring_stiffness", "greedy_threshold",
               "threads"});
  DesignSettings& settings = scene.design;
  const auto choose = [&](std::string_view key, std::initializer_list<std::string_view> choices,
                          std::string& value) {
    value = design.one_of(key, std::span(choices.begin(), choices.size())).value_or(value);
  };
  choose("method", {"force-balance", "dense-springs"}, settings.method);
  choose("objective", {"max", "rms"}, settings.objective);
  read_symmetry(design, settings);
  choose("optimizer", {"gauss-newton", "ipopt", "mma", "ccsaq"}, settings.optimizer);
  choose("hessian", {"limited-memory", "gauss-newton", "exact"}, settings.hessian);
  if (design.has("hessian"))
    if (const auto problem = hessian_problem(settings)) design.fail("hessian", *problem);
  settings.max_error = design.positive("max_error").value_or(settings.max_error);
  settings.cables = design.integer("cables", 1);
  settings.longest_cable = design.positive("longest_cable");
  settings.threads = design.integer("threads", 1);
  settings.spring_stiffness =
      design.positive("spring_stiffness").value_or(settings.spring_stiffness);
  settings.greedy_threshold =
      design.positive("greedy_threshold").value_or(settings.greedy_threshold);
  settings.sparsity_weights =
      design.numbers("sparsity_weights").value_or(settings.sparsity_weights);
  const auto& weights = settings.sparsity_weights;
  if (weights.empty() || weights[0] < 0 ||
      std::ranges::adjacent_find(weights, std::greater_equal{}) != weights.end())
    design.fail("sparsity_weights", "expected increasing numbers that are not negative");
  settings.external = design.boolean("external").value_or(settings.external);
  if (design.has("external") && settings.external && scene.anchors.cols() == 0)
    design.fail("external",
                "is true, but the scene has no anchors; add anchors = [[x, y, z], ...] or "
                "frame = {shape = \"cube\"}");
  settings.hand_over = design.boolean("hand_over").value_or(settings.hand_over);
  if (settings.hand_over && scene.pinned.empty())
    design.fail("hand_over", "is true, but the scene has no pinned vertices to hand over");
  if (settings.hand_over && scene.anchors.cols() == 0)
    design.fail("hand_over",
                "is true, but the scene has no anchors to hand its pins over to; add anchors = "
                "[[x, y, z], ...] or frame = {shape = \"cube\"}");
  read_rod_pairs(design, scene);
  read_weights(design, scene);
  read_forbidden(design, scene);
}

// The corners of a frame about all targets.
Eigen::Matrix3Xd frame_anchors(const TomlTable& frame, const Scene& scene) {
  frame.only({"shape", "margin"});
  const std::string shape = frame.need(
      "shape", frame.one_of("shape", std::array<std::string_view, 2>{"cube", "tetrahedron"}));
  std::vector<Polyline> targets;
  Eigen::Index vertices = 0;
  for (const SceneRod& rod : scene.rods) {
    targets.push_back(rod.target);
    vertices += rod.target.points.cols();
  }
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
      margin, scene.planar);
}

Scene parse_scene(const TomlTable& root, const std::filesystem::path& path) {
  root.only({"name", "length_unit", "force_unit", "planar", "anchors", "frame", "pinned", "gravity",
             "loads", "rod", "design"});
  Scene scene;
  scene.name = root.text("name").value_or(path.stem().string());
  scene.source = path.string();
  scene.length_unit = root.one_of("length_unit", length_units).value_or(scene.length_unit);
  scene.force_unit = root.one_of("force_unit", force_units).value_or(scene.force_unit);
  scene.planar = root.boolean("planar").value_or(scene.planar);
  scene.anchors = root.points("anchors").value_or(scene.anchors);
  read_rods(root, path.parent_path(), root.point("gravity").value_or(Eigen::Vector3d::Zero()),
            scene);
  if (const auto frame = root.table("frame")) {
    if (root.has("anchors"))
      root.fail("frame", "its corners are the anchors; give either frame or anchors");
    scene.anchors = frame_anchors(*frame, scene);
  }
  for (const TomlTable& pin : root.tables("pinned")) scene.pinned.push_back(read_pin(pin, scene));
  for (const TomlTable& load : root.tables("loads"))
    scene.point_loads.push_back(read_load(load, scene));
  if (const auto design = root.table("design")) read_design(*design, scene);
  check_vertices(scene.rods, path.string());
  if (scene.planar) check_plane(scene, root.where("planar"));
  return scene;
}

}  // namespace

std::optional<std::string> hessian_problem(const DesignSettings& settings) {
  if (settings.optimizer == "gauss-newton" && settings.hessian == "limited-memory")
    return "limited-memory is for ipopt; for gauss-newton use gauss-newton or exact";
  if (settings.optimizer != "gauss-newton" && settings.optimizer != "ipopt")
    return "belongs to the optimizer ipopt or gauss-newton; " + settings.optimizer +
           " uses gradients only";
  return std::nullopt;
}

core::Expected<Scene> read_scene(const std::filesystem::path& path) {
  return guarded([&] {
    const std::string text = value_or_fail(read_file(path));
    const toml::table content = TomlTable::parse(text, path.string());
    return parse_scene(TomlTable(content, path.string()), path);
  });
}

core::Expected<Scene> scene_of_curves(std::vector<Polyline> curves,
                                      const std::filesystem::path& source) {
  return guarded([&] {
    Scene scene;
    scene.name = source.stem().string();
    scene.source = source.string();
    for (Polyline& curve : curves)
      scene.rods.push_back(plain_rod(std::move(curve), source.string()));
    if (scene.rods.empty()) fail(source.string(), "holds no curves");
    check_vertices(scene.rods, source.string());
    const Section all =
        section({}, default_radius(scene.rods), {scene.length_unit, scene.force_unit});
    for (SceneRod& rod : scene.rods) rod.section = all;
    return scene;
  });
}

}  // namespace tencer::io
