#include "design/published_json.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tencer/der/section.hpp>

#include "design/design_parts.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

void read_published_rod(const JsonValue& value, model::Design& design) {
  der::Rod rod;
  rod.closed = value["closed"].boolean();
  rod.section = published_section(value["youngs_modulus"], value["radius"]);
  for (const JsonValue& length : value["rest_lengths"].items()) length.positive();
  rod.rest_lengths = value["rest_lengths"].numbers();
  design.target.push_back(read_shape(value["target"], rod.closed));
  design.pose.push_back(read_shape(value["published_equilibrium"], rod.closed));
  const long n = design.target.back().cols();
  check_count(value["published_equilibrium"], design.pose.back().cols(), n, "points, as in target");
  check_count(value["rest_lengths"], rod.edges(), rod.closed ? n : n - 1, "numbers");
  design.structure.rods.push_back(std::move(rod));
}

}  // namespace

der::Section published_section(const JsonValue& youngs_modulus, const JsonValue& radius) {
  constexpr double least = 1e-90;
  constexpr double most = 1e90;
  const double E = youngs_modulus.positive();
  const double r = radius.positive();
  for (const double size : {E * r * r, E * r * r * r * r})
    if (!(size > least && size < most))
      radius.fail("with this modulus no rod has stiffnesses near " + to_text(size));
  const der::Section circle = der::solid_circle(E, 0.5, r);
  const double angle = 2 * std::numbers::pi / 1000;
  const double area = std::sin(angle) / angle;
  const double inertia = area * (2 + std::cos(angle)) / 3;
  return {.EA = circle.EA * area,
          .EI1 = circle.EI1 * inertia,
          .EI2 = circle.EI2 * inertia,
          .GJ = circle.GJ * inertia,
          .shape = circle.shape};
}

void build_in_pose(model::Design& design, const JsonValue& cables) {
  design.target_directors.assign(design.target.size(), Eigen::Matrix3Xd(3, 0));
  design.pose_directors = design.target_directors;
  design.built = model::built_in_pose(design.structure, design.pose);
  for (std::size_t c = 0; c < design.built.size(); ++c)
    if (!(design.built[c].length > 0))
      cables.fail("the two ends of cable " + std::to_string(c) + " are the same point");
  for (const model::BuiltCable& cable : design.built)
    if (!(std::abs(cable.tension) <= largest_number))
      cables.fail("a cable pulls with " + to_text(cable.tension));
}

bool are_flat(const std::vector<Eigen::Matrix3Xd>& rods) {
  return std::ranges::all_of(rods, [&](const Eigen::Matrix3Xd& points) {
    return (points.row(2).array() == rods[0](2, 0)).all();
  });
}

bool is_published(const nlohmann::json& content) {
  if (!content.is_object() || content.contains("schema") || !content.contains("rods")) return false;
  const nlohmann::json& rods = content["rods"];
  return rods.is_array() && !rods.empty() && rods[0].is_object() &&
         rods[0].contains("published_equilibrium");
}

model::Design design_from_published(const JsonValue& root) {
  model::Design design;
  model::Structure& structure = design.structure;
  if (root.has("name")) design.name = root["name"].text();
  for (const JsonValue& rod : root["rods"].items()) read_published_rod(rod, design);
  if (structure.rods.empty()) root["rods"].fail("expected at least one rod");
  if (root.has("anchors")) structure.anchors = root["anchors"].points();
  structure.planar = are_flat(design.target);
  for (const JsonValue& cable : root["cables"].items())
    structure.cables.push_back({.a = read_end(cable["a"], structure),
                                .b = read_end(cable["b"], structure),
                                .stiffness = cable["stiffness"].positive(),
                                .rest_length = cable["rest_length"].at_least_zero()});
  build_in_pose(design, root["cables"]);
  return design;
}

}  // namespace tencer::io
