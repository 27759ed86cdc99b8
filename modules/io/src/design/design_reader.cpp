#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "design/design_json.hpp"
#include "design/design_parts.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

using namespace model;

std::string optional_text(const JsonValue& object, std::string_view key) {
  return object.has(key) ? object[key].text() : std::string();
}

// One direction an edge, none along it.
Eigen::Matrix3Xd read_directors(const JsonValue& value, const Eigen::Matrix3Xd& points, int edges) {
  constexpr double least = 1e-6;  // sine of the angle to the edge
  const Eigen::Matrix3Xd directors = value.points();
  check_count(value, directors.cols(), edges, "directions, one an edge");
  for (int j = 0; j < edges; ++j) {
    const Eigen::Vector3d t = (points.col((j + 1) % points.cols()) - points.col(j)).normalized();
    const Eigen::Vector3d m1 = directors.col(j);
    if (!(m1.cross(t).norm() > least * m1.norm()))
      value.items()[j].fail("expected a direction that is not along the edge");
  }
  return directors;
}

// What only some rods have: number r of the design.
void read_frames(const JsonValue& value, int r, Design& design) {
  der::Rod& rod = design.structure.rods[r];
  const int edges = rod.edges();
  const int bends = rod.closed ? edges : edges - 1;
  if (value.has("closing_angle")) {
    if (!rod.closed) value["closing_angle"].fail("belongs to closed rods");
    rod.closing_angle = value["closing_angle"].number();
  }
  if (value.has("rest_curvature")) {
    const std::vector<JsonValue> pairs = value["rest_curvature"].items();
    check_count(value["rest_curvature"], static_cast<long>(pairs.size()), bends, "pairs");
    rod.rest_curvature.resize(2, bends);
    for (int b = 0; b < bends; ++b) {
      check_count(pairs[b], pairs[b].numbers().size(), 2, "numbers");
      rod.rest_curvature.col(b) = pairs[b].numbers();
    }
  }
  if (value.has("rest_twist")) {
    rod.rest_twist = value["rest_twist"].numbers();
    check_count(value["rest_twist"], rod.rest_twist.size(), bends, "numbers");
  }
  if (value.has("target_directors"))
    design.target_directors[r] = read_directors(value["target_directors"], design.target[r], edges);
  if (value.has("pose_directors"))
    design.pose_directors[r] = read_directors(value["pose_directors"], design.pose[r], edges);
}

der::Shape read_section(const JsonValue& value) {
  const std::string shape = value["shape"].text();
  if (shape == "circle") return der::Circle{value["radius"].positive()};
  if (shape == "tube") {
    const der::Tube tube{value["outer_radius"].positive(), value["inner_radius"].at_least_zero()};
    if (tube.inner_radius >= tube.outer_radius)
      value["inner_radius"].fail("must be smaller than outer_radius");
    return tube;
  }
  if (shape == "rectangle")
    return der::Rectangle{value["width"].positive(), value["height"].positive()};
  value["shape"].fail("expected \"circle\", \"tube\" or \"rectangle\", found \"" + shape + "\"");
}

Material read_material(const JsonValue& value) {
  Material material{.name = value["name"].text(),
                    .youngs_modulus = value["youngs_modulus"].positive(),
                    .strain_limit = value["strain_limit"].positive(),
                    .breaking_strain = value["breaking_strain"].positive()};
  if (value.has("density")) material.density = value["density"].at_least_zero();
  if (const auto known = find_material(material.name)) material.source = known->source;
  return material;
}

BendingStrain read_strain(const JsonValue& value, const der::Rod& rod) {
  return {.strain = value["largest"].at_least_zero(),
          .curvature = value["curvature"].at_least_zero(),
          .vertex = value["vertex"].index(rod.vertices(), "vertex"),
          .s = read_arc_length(value, rod)};
}

// What is known of a rod's build: all rods have a material, or none.
void read_build(const JsonValue& value, Design& design) {
  Structure& structure = design.structure;
  der::Rod& rod = structure.rods.back();
  const bool first = structure.rods.size() == 1;
  if (value.has("section")) rod.section.shape = read_section(value["section"]);
  if (value.has("material") == structure.materials.empty() && !first)
    value.fail("either every rod has a material or none has");
  if (value.has("material")) structure.materials.push_back(read_material(value["material"]));
  if (value.has("bending_strain")) {
    design.strains.resize(structure.rods.size());
    design.strains.back() = read_strain(value["bending_strain"], rod);
  }
}

void read_rod(const JsonValue& value, Design& design) {
  der::Rod& rod = design.structure.rods.emplace_back();
  rod.closed = value["closed"].boolean();
  rod.section.EA = value["EA"].positive();
  const std::vector<JsonValue> bending = value["EI"].items();
  if (bending.size() != 2)
    value["EI"].fail("expected [a, b], found an array of " + std::to_string(bending.size()));
  rod.section.EI1 = bending[0].positive();
  rod.section.EI2 = bending[1].positive();
  rod.section.GJ = value["GJ"].positive();
  const auto& target = design.target.emplace_back(read_shape(value["target"], rod.closed));
  const auto& pose = design.pose.emplace_back(read_shape(value["pose"], rod.closed));
  const int n = static_cast<int>(target.cols());
  check_count(value["pose"], pose.cols(), n, "points, as in target");
  for (const JsonValue& item : value["rest_lengths"].items()) item.positive();
  rod.rest_lengths = value["rest_lengths"].numbers();
  check_count(value["rest_lengths"], rod.rest_lengths.size(), rod.closed ? n : n - 1, "numbers");
  design.target_directors.emplace_back(3, 0);
  design.pose_directors.emplace_back(3, 0);
  read_build(value, design);
  read_frames(value, static_cast<int>(design.structure.rods.size()) - 1, design);
}

View read_view(const JsonValue& value) {
  return {.direction = value["direction"].point(), .weight = value["weight"].number()};
}

Pin read_pin(const JsonValue& value, const std::vector<der::Rod>& rods) {
  Pin pin;
  pin.rod = value["rod"].index(static_cast<int>(rods.size()), "rod");
  pin.vertex = value["vertex"].index(rods[pin.rod].vertices(), "vertex");
  pin.axes = {false, false, false};
  const std::string axes = value["axes"].text();
  for (const char axis : axes) {
    const std::size_t at = axis_names.find(axis);
    if (at == std::string_view::npos)
      value["axes"].fail("expected letters of \"xyz\", found \"" + axes + "\"");
    pin.axes[at] = true;
  }
  if (axes.empty()) value["axes"].fail("expected letters of \"xyz\", found none");
  return pin;
}

PointLoad read_point_load(const JsonValue& value, const std::vector<der::Rod>& rods) {
  PointLoad load;
  load.rod = value["rod"].index(static_cast<int>(rods.size()), "rod");
  load.s = read_arc_length(value, rods[load.rod]);
  load.force = value["force"].point();
  return load;
}

LineLoad read_line_load(const JsonValue& value, const std::vector<der::Rod>& rods) {
  return {.rod = value["rod"].index(static_cast<int>(rods.size()), "rod"),
          .force_per_length = value["force_per_length"].point()};
}

void read_cable(const JsonValue& value, Design& design) {
  springs::Cable cable{.a = read_end(value["a"], design.structure),
                       .b = read_end(value["b"], design.structure)};
  if (std::holds_alternative<springs::AtAnchor>(cable.a) &&
      std::holds_alternative<springs::AtAnchor>(cable.b))
    value.fail("a cable from anchor to anchor holds no rod");
  design.built.push_back(
      {.length = value["length"].positive(), .tension = value["tension"].number()});
  if (value.has("stiffness") != value.has("rest_length"))
    value.fail("stiffness and rest_length belong together: give both or neither");
  if (value.has("stiffness")) {
    cable.stiffness = value["stiffness"].positive();
    cable.rest_length = value["rest_length"].at_least_zero();
  }
  design.structure.cables.push_back(cable);
}

Certificate read_certificate(const JsonValue& value) {
  Certificate certificate{.residual = value["residual"].number(),
                          .smallest_eigenvalue = value["smallest_eigenvalue"].number(),
                          .slack_cables = value["slack_cables"].integer(0),
                          .stable = value["stable"].boolean()};
  if (value.has("off_by_errors"))
    certificate.off_by_errors = value["off_by_errors"].at_least_zero();
  if (value.has("settles_from_target"))
    certificate.settles_from_target = value["settles_from_target"].boolean();
  return certificate;
}

AtLeast read_at_least(const JsonValue& value, const std::vector<der::Rod>& rods) {
  AtLeast at_least{.cables = value["cables"].integer(0),
                   .ends = value["cable_ends"].integer(0),
                   .error_percent = value["error_percent"].positive()};
  for (const JsonValue& stretch : value["stretches"].items())
    at_least.stretches.push_back({.rod = stretch["rod"].index(static_cast<int>(rods.size()), "rod"),
                                  .from = stretch["from"].at_least_zero(),
                                  .to = stretch["to"].positive()});
  return at_least;
}

double read_percent(const JsonValue& value) {
  return value.raw().is_null() ? std::numeric_limits<double>::quiet_NaN() : value.at_least_zero();
}

StageRow read_trace_row(const JsonValue& value) {
  StageRow row;
  row.stage = value["stage"].text();
  row.seconds = value["seconds"].at_least_zero();
  row.cables = value["cables"].integer(0);
  row.max_percent = read_percent(value["max_percent"]);
  row.rms_percent = read_percent(value["rms_percent"]);
  if (value.has("equilibrium_solves")) row.solves = value["equilibrium_solves"].integer(0);
  if (value.has("newton_iterations")) row.iterations = value["newton_iterations"].integer(0);
  row.note = optional_text(value, "note");
  if (value.has("snapshots")) row.snapshots = read_snapshots(value["snapshots"]);
  return row;
}

DesignStatus read_status(const JsonValue& value) {
  const std::string text = value.text();
  for (const DesignStatus status :
       {DesignStatus::complete, DesignStatus::tolerance_not_reached, DesignStatus::interrupted})
    if (text == status_name(status)) return status;
  value.fail("expected \"complete\", \"tolerance-not-reached\" or \"interrupted\", found \"" +
             text + "\"");
}

void read_structure(const JsonValue& root, Design& design) {
  Structure& structure = design.structure;
  for (const JsonValue& rod : root["rods"].items()) read_rod(rod, design);
  if (!design.strains.empty()) design.strains.resize(structure.rods.size());
  if (structure.rods.empty()) root["rods"].fail("expected at least one rod");
  const auto each = [&](const char* key, auto&& read) {
    if (root.has(key))
      for (const JsonValue& item : root[key].items()) read(item);
  };
  if (root.has("anchors")) structure.anchors = root["anchors"].points();
  each("pinned",
       [&](const JsonValue& pin) { structure.pins.push_back(read_pin(pin, structure.rods)); });
  each("point_loads", [&](const JsonValue& load) {
    structure.point_loads.push_back(read_point_load(load, structure.rods));
  });
  each("line_loads", [&](const JsonValue& load) {
    structure.line_loads.push_back(read_line_load(load, structure.rods));
  });
  if (root.has("planar")) structure.planar = root["planar"].boolean();
  each("views", [&](const JsonValue& view) { design.views.push_back(read_view(view)); });
  if (const auto problem = model::view_problem(design.views)) root["views"].fail(*problem);
  if (structure.planar && !design.views.empty())
    root["views"].fail("a planar design is seen along z as it is: it has no views");
  for (const JsonValue& cable : root["cables"].items()) read_cable(cable, design);
}

}  // namespace

Design design_from_json(const JsonValue& root) {
  Design design;
  if (!root.raw().is_object()) root.fail("is not a design: expected an object");
  const std::string found = root["schema"].text();
  if (found != design_schema && found != older_schema)
    root["schema"].fail("expected \"" + std::string(design_schema) + "\" or \"" + older_schema +
                        "\", found \"" + found + "\"");
  design.name = optional_text(root, "name");
  if (root.has("status")) design.status = read_status(root["status"]);
  design.length_unit = root["length_unit"].text();
  design.force_unit = root["force_unit"].text();
  read_structure(root, design);
  if (root.has("error")) {
    const JsonValue error = root["error"];
    design.error =
        DesignError{error["max_percent"].at_least_zero(), error["rms_percent"].at_least_zero()};
  }
  if (root.has("at_least"))
    design.at_least = read_at_least(root["at_least"], design.structure.rods);
  if (root.has("certificate")) design.certificate = read_certificate(root["certificate"]);
  if (root.has("trace"))
    for (const JsonValue& row : root["trace"].items()) design.trace.push_back(read_trace_row(row));
  return design;
}

}  // namespace tencer::io
