#include "scene/scene_rods.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tencer/curves/families.hpp>
#include <tencer/geometry/sampling.hpp>
#include <tencer/geometry/spline.hpp>
#include <tencer/io/curve.hpp>
#include <tencer/model/rest_shape.hpp>
#include <tencer/model/units.hpp>
#include <utility>

#include "curves/finish_curve.hpp"
#include "curves/round_curve.hpp"
#include "scene/scene_section.hpp"
#include "scene/vertex_limit.hpp"
#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

using curves::Family;
using geometry::Polyline;

constexpr int min_vertices = 3;

std::vector<Polyline> family_targets(const TomlTable& rod) {
  const std::vector<Family> known = curves::families();
  std::vector<std::string_view> names;
  for (const Family& family : known) names.push_back(family.name);
  const std::string name = *rod.one_of("family", names);
  const Family& family = *std::ranges::find(known, name, &Family::name);

  std::vector<double> values;
  for (const curves::FamilyParameter& parameter : family.parameters)
    values.push_back(parameter.standard);
  if (const auto given = rod.table("parameters")) {
    std::vector<std::string_view> keys;
    for (const curves::FamilyParameter& parameter : family.parameters)
      keys.push_back(parameter.name);
    given->only(keys);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = given->number(keys[i]).value_or(values[i]);
  }
  const int vertices =
      rod.integer("vertices", min_vertices, most_vertices).value_or(family.vertices);
  if (const auto problem = curves::family_problem(family, values, vertices))
    rod.fail(rod.has("parameters") ? "parameters" : "family", *problem);
  return curves::family_curves(family, values, vertices);
}

// That, with the scene's units, and what of the curves its author may want to know.
struct Source : RodSource {
  Units units{};
  std::vector<std::string>& notes;
};

std::vector<Polyline> numbered_target(const TomlTable& rod, const Source& source) {
  const int most = static_cast<int>(source.curves.size()) - 1;
  return {source.curves[*rod.integer("curve", 0, most)]};
}

std::vector<Polyline> file_targets(const TomlTable& rod, const Source& source) {
  if (!source.curves.empty() && !rod.is_text("curve")) return numbered_target(rod, source);
  const std::filesystem::path file = source.folder / *rod.text("curve");
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    rod.fail("curve", "there is no file " + file.string());
  CurveFile content = value_or_fail(read_curve_file(file));
  source.notes.insert(source.notes.end(), content.notes.begin(), content.notes.end());
  if (!rod.has("closed"))
    source.notes.insert(source.notes.end(), content.open_ends.begin(), content.open_ends.end());
  if (content.length_unit && *content.length_unit != source.units.length)
    source.notes.push_back(file.string() + " says that its numbers are " + *content.length_unit +
                           ", but the scene's length_unit is " + source.units.length +
                           ", and that is taken");
  limit_vertices(content.curves, file.string(), source.notes);
  return std::move(content.curves);
}

// A smooth curve through the points that are given.
std::vector<Polyline> spline_targets(const TomlTable& rod, const Source& source) {
  constexpr int standard_vertices = 100;
  const std::string where = rod.where("spline");
  ListedCurve listed;
  listed.where = where;
  listed.where_of = [&](int) { return where; };
  listed.name_of = [](int i) { return "point " + std::to_string(i); };
  const Eigen::Matrix3Xd points = *rod.points("spline");
  for (const auto& point : points.colwise()) listed.points.emplace_back(point);
  const int vertices =
      rod.integer("vertices", min_vertices, most_vertices).value_or(standard_vertices);
  CurveFile through;
  finish_curve(listed, through);
  source.notes.insert(source.notes.end(), through.notes.begin(), through.notes.end());
  return {geometry::sample_spline(through.curves[0], vertices)};
}

// What the table says of it, where the curves are not so already.
void close_or_check(const TomlTable& table, std::vector<Polyline>& curves) {
  const auto closed = table.boolean("closed");
  if (!closed) return;
  for (Polyline& curve : curves) {
    if (curve.closed && !*closed)
      table.fail("closed",
                 "is false, but the curve is closed: its end meets its start; remove the key or "
                 "open the curve");
    if (*closed)
      if (const auto problem = close_curve(curve)) table.fail("closed", "is true, but " + *problem);
  }
}

// Rounded to the radius that is asked for, and with as many vertices as the table says.
void smooth_or_resample(const TomlTable& table, const Source& source,
                        std::vector<Polyline>& curves) {
  const auto vertices = table.integer("vertices", min_vertices, most_vertices);
  const auto said = table.positive("smooth");
  const auto radius = source.smooth ? source.smooth : said;
  for (Polyline& curve : curves) {
    const auto problem =
        radius ? round_curve(*radius, vertices, source.units.length, curve, source.notes)
               : std::nullopt;
    if (problem && source.smooth) fail(table.where(), "--smooth: " + *problem);
    if (problem) table.fail("smooth", *problem);
    if (vertices && table.has("curve")) curve = geometry::resample(curve, *vertices);
  }
}

// The curves that a table names by `curve` and `index`, by `family` and `parameters`, or by
// `spline`.
std::vector<Polyline> curves_of(const TomlTable& table, const Source& source) {
  if (table.has("curve") + table.has("family") + table.has("spline") != 1)
    fail(table.where(),
         "a rod needs either curve = \"FILE\" or family = \"NAME\" or spline = [[x, y, z], ...]");
  if (table.has("parameters") && !table.has("family"))
    table.fail("parameters", "belongs to family only");
  if (table.has("index") && table.has("spline"))
    table.fail("index", "belongs to curve or family; a spline is one curve");
  std::vector<Polyline> curves = table.has("curve")    ? file_targets(table, source)
                                 : table.has("family") ? family_targets(table)
                                                       : spline_targets(table, source);
  if (const auto index = table.integer("index", 0)) {
    if (*index >= static_cast<int>(curves.size()))
      table.fail("index", "there is no curve " + std::to_string(*index) + "; " +
                              index_range(static_cast<int>(curves.size())));
    curves = {curves[*index]};
  }
  close_or_check(table, curves);
  smooth_or_resample(table, source, curves);
  return curves;
}

Eigen::Vector3d direction(const TomlTable& table, std::string_view key) {
  const Eigen::Vector3d vector = *table.point(key);
  if (vector.isZero(0)) table.fail(key, "expected a direction, found [0, 0, 0]");
  return vector;
}

model::RestShape read_rest(const TomlTable& rest, const Source& source) {
  model::RestShape shape;
  if (rest.has("curvature")) {
    rest.only({"curvature"});
    shape.curvature = *rest.number("curvature");
    return shape;
  }
  rest.only({"curve", "index", "family", "parameters", "spline", "vertices", "smooth", "director",
             "curvature"});
  std::vector<Polyline> curves = curves_of(rest, source);
  if (curves.size() != 1)
    fail(rest.where(), "rest names " + std::to_string(curves.size()) +
                           " curves; say which with index = 0, 1, ...");
  shape.curve = std::move(curves[0]);
  if (rest.has("director")) shape.director = direction(rest, "director");
  return shape;
}

// What a [[rod]] table says of each of its rods.
struct ListedRod {
  Polyline target{};
  model::RestShape rest{};
  std::optional<Eigen::Vector3d> director{};
  std::optional<double> closing_angle{};
  SectionWish section{};
};

// Between one vertex and the next a rod bends by an angle, not by turns.
void check_rest_curvature(const TomlTable& table, const ListedRod& rod) {
  const double bend = std::abs(rod.rest.curvature) * geometry::edge_lengths(rod.target).maxCoeff();
  if (bend > 1)
    table.fail("rest", "with this curvature the rod bends by " + to_text(bend) +
                           " radians from one vertex to the next; use more vertices, so that it "
                           "is at most 1");
}

// What a rest curve must have in common with the target.
void check_rest_curve(const TomlTable& table, const ListedRod& rod) {
  constexpr double allowed = 0.01;
  const Polyline& curve = *rod.rest.curve;
  if (curve.closed != rod.target.closed)
    table.fail("rest", std::string("the curve at rest is ") + (curve.closed ? "closed" : "open") +
                           ", the target is not; both must be the same");
  const double length = geometry::edge_lengths(curve).sum();
  const double target = geometry::edge_lengths(rod.target).sum();
  if (std::abs(length - target) > allowed * target)
    table.fail("rest", "the curve at rest is " + to_text(length) + " long and the target " +
                           to_text(target) + "; they must agree to 1 %");
}

std::vector<ListedRod> read_rod(const TomlTable& table, const Source& source) {
  table.only(rod_keys);
  std::vector<Polyline> curves = curves_of(table, source);
  const SectionWish section = section_wish(table, source.units, source.material);
  std::vector<ListedRod> rods;
  for (Polyline& curve : curves) {
    ListedRod rod;
    rod.target = std::move(curve);
    rod.section = section;
    if (table.has("director")) rod.director = direction(table, "director");
    if (const auto rest = table.table("rest")) {
      rod.rest = read_rest(*rest, source);
      if (rod.rest.curve) check_rest_curve(table, rod);
      check_rest_curvature(table, rod);
    }
    if (const auto turns = table.number("closing_turns")) {
      if (!rod.target.closed) table.fail("closing_turns", "belongs to closed rods");
      rod.closing_angle = 2 * std::numbers::pi * *turns;
    }
    rods.push_back(std::move(rod));
  }
  return rods;
}

// Directors are for rods that can tell their axes apart, and bent strips need one.
void check_directors(const TomlTable& table, const ListedRod& rod, const der::Section& section) {
  const bool round = section.EI1 == section.EI2;
  const bool straight = !rod.rest.curve && rod.rest.curvature == 0;
  if (rod.director && round && straight)
    table.fail("director",
               "has no meaning: the section bends alike about all axes and the rod is "
               "straight at rest");
  if (rod.rest.curve && !rod.rest.director && !round)
    table.fail("rest",
               "needs director = [x, y, z], the direction of the section's first axis at "
               "the start of the curve");
}

// Sizes that no rod has: computing with them would overflow, or divide by zero.
void check_stiffness(const TomlTable& table, const der::Section& section) {
  for (const double stiffness : {section.EA, section.EI1, section.EI2, section.GJ})
    if (!(stiffness >= 1 / largest_number && stiffness <= largest_number))
      table.fail("section", "makes a stiffness of " + to_text(stiffness) +
                                "; look at its sizes, modulus and units");
}

// Adds the rod to the scene, with its weight when there is gravity (m/s^2).
void add(const ListedRod& listed, double radius, const Eigen::Vector3d& gravity,
         const TomlTable& table, model::Scene& scene) {
  const Units units{scene.length_unit, scene.force_unit};
  model::add_rod(scene, listed.target, listed.section.material);
  der::Rod& rod = scene.structure.rods.back();
  rod.section = section(listed.section, radius, units);
  check_stiffness(table, rod.section);
  rod.closing_angle = listed.closing_angle;
  model::set_rest_shape(listed.rest, rod);
  scene.directors.back() = listed.director;
  check_directors(table, listed, rod.section);
  if (gravity.isZero(0)) return;
  const auto mass = mass_per_length(listed.section, rod.section, units);
  if (!mass) fail(table.where(), "gravity needs section.mass_per_length, in kg/m");
  scene.structure.line_loads.push_back(
      {static_cast<int>(scene.structure.rods.size()) - 1,
       *mass * gravity * (model::metres(units.length) / model::newtons(units.force))});
}

// The radius of rods that say none: one stock, thin enough for each of them.
double radius_for(const std::vector<ListedRod>& rods) {
  std::vector<Polyline> targets;
  for (const ListedRod& rod : rods)
    if (rod.section.radius_to_choose()) targets.push_back(rod.target);
  double radius = std::numeric_limits<double>::infinity();
  for (const ListedRod& rod : rods)
    if (rod.section.radius_to_choose())
      radius = std::min(radius, model::chosen_radius(targets, rod.section.material));
  return radius;
}

void check_number(const std::vector<ListedRod>& rods, const TomlTable& root) {
  long vertices = 0;
  for (const ListedRod& rod : rods) vertices += rod.target.vertices();
  if (vertices > most_vertices)
    fail(root.where(), "the rods have " + std::to_string(vertices) +
                           " vertices altogether, more than " + std::to_string(most_vertices) +
                           "; a design takes a tenth of that, so say fewer vertices of the rods");
}

}  // namespace

void read_rods(const TomlTable& root, const RodSource& given, const Eigen::Vector3d& gravity,
               model::Scene& scene) {
  const Source source{given, {scene.length_unit, scene.force_unit}, scene.notes};
  std::vector<ListedRod> rods;
  std::vector<TomlTable> tables;
  for (const TomlTable& table : root.tables("rod"))
    for (ListedRod& listed : read_rod(table, source)) {
      rods.push_back(std::move(listed));
      tables.push_back(table);
    }
  if (rods.empty()) fail(root.where(), "a scene needs at least one [[rod]] table");
  check_number(rods, root);
  const double radius = radius_for(rods);
  for (std::size_t i = 0; i < rods.size(); ++i) add(rods[i], radius, gravity, tables[i], scene);
}

}  // namespace tencer::io
