#include <algorithm>
#include <cmath>
#include <utility>

#include "curves/finish_curve.hpp"
#include "design/design_parts.hpp"
#include "design/published_json.hpp"

namespace tencer::io {
namespace {

// How springs are told (restVarType): by vertices, or by arc lengths after their stiffnesses. The
// other two ways leave out what a design needs.
enum class Springs { on_vertices = 0, along_rods = 3 };

// Its closed rods are open ones whose last edge lies upon the first, so that they have two vertices
// more than we count; in `defoVars` these and their angle are left out and one angle is added.
struct Sizes {
  bool closed = false;
  long vertices = 0;  // as we count

  long stored_vertices() const { return vertices + (closed ? 2 : 0); }
  long stored_edges() const { return stored_vertices() - 1; }
  long target_unknowns() const { return 3 * stored_vertices() + stored_edges(); }
  long pose_unknowns() const { return closed ? 4 * vertices + 1 : 4 * vertices - 1; }
};

// The points at the start of a rod's unknowns.
Eigen::Matrix3Xd points_of(const JsonValue& value, const Eigen::VectorXd& unknowns, long from,
                           const Sizes& sizes) {
  const Eigen::Matrix3Xd points =
      unknowns.segment(from, 3 * sizes.vertices).reshaped(3, sizes.vertices);
  if (const auto bad = bad_edge({points, sizes.closed}))
    value.fail(std::string("of a rod at vertex ") + std::to_string(bad->from) +
               (bad->no_length ? ": its edge has no length" : ": the rod turns straight back"));
  return points;
}

// The members of an array that has one for each of so many things.
std::vector<JsonValue> each(const JsonValue& value, long count, const std::string& of) {
  std::vector<JsonValue> items = value.items();
  check_count(value, static_cast<long>(items.size()), count, "entries, one a " + of);
  return items;
}

void read_rods(const JsonValue& root, model::Design& design) {
  const int open = root["numOpenRods"].integer(0);
  const int rods = open + root["numClosedRods"].integer(0);
  if (rods == 0) root["numClosedRods"].fail("expected at least one rod");
  const auto moduli = each(root["YoungModulus"], rods, "rod");
  const auto radii = each(root["crossSection"], rods, "rod");
  const auto lengths = each(root["rodRestLengths"], rods, "rod");
  const auto targets = each(root["targetDefoVars"], rods, "rod");
  const Eigen::VectorXd pose = root["defoVars"].numbers();
  long at = 0;
  for (int r = 0; r < rods; ++r) {
    for (const JsonValue& length : lengths[r].items()) length.positive();
    const Eigen::VectorXd stored = lengths[r].numbers();
    const bool closed = r >= open;
    const Sizes sizes{closed, stored.size() + (closed ? -1 : 1)};
    if (sizes.vertices < (closed ? 3 : 2)) lengths[r].fail("holds too few edges for a rod");
    const Eigen::VectorXd target = targets[r].numbers();
    check_count(targets[r], target.size(), sizes.target_unknowns(), "numbers");
    if (pose.size() < at + sizes.pose_unknowns()) root["defoVars"].fail("holds too few numbers");
    design.structure.rods.push_back(
        {.closed = closed,
         .section = published_section(moduli[r], radii[r]),
         .rest_lengths = stored.head(closed ? sizes.vertices : sizes.vertices - 1)});
    design.target.push_back(points_of(targets[r], target, 0, sizes));
    design.pose.push_back(points_of(root["defoVars"], pose, at, sizes));
    at += sizes.pose_unknowns();
  }
  check_count(root["defoVars"], pose.size(), at, "numbers");
}

// A number that a file spells with or without a point.
int whole(const JsonValue& value, int below, const std::string& of) {
  const double number = value.number();
  if (number != std::floor(number) || number < 0 || number >= below)
    value.fail("there is no such " + of + " of " + std::to_string(below));
  return static_cast<int>(number);
}

springs::OnRod at_vertex(const JsonValue& rod, const JsonValue& vertex,
                         const model::Structure& structure) {
  const int r = whole(rod, static_cast<int>(structure.rods.size()), "rod");
  const der::Rod& on = structure.rods[r];
  const int v = whole(vertex, on.vertices() + (on.closed ? 2 : 0), "vertex") % on.vertices();
  return {r, on.rest_lengths.head(v).sum()};
}

springs::OnRod along(const JsonValue& s, int r, const model::Structure& structure) {
  const double length = structure.rods[r].length();
  const double given = s.number();
  if (std::abs(given) > 2 * length) s.fail("is not an arc length of rod " + std::to_string(r));
  const double wrapped = given - length * std::floor(given / length);
  return {r, structure.rods[r].closed ? wrapped : std::clamp(given, 0.0, length)};
}

// Where the springs are tied, two ends each.
std::vector<std::pair<springs::OnRod, springs::OnRod>> read_ends(
    const JsonValue& root, Springs springs, int count, const model::Structure& structure) {
  std::vector<std::pair<springs::OnRod, springs::OnRod>> ends;
  if (springs == Springs::on_vertices) {
    for (const JsonValue& tied : each(root["attachmentVertices"], count, "spring")) {
      const auto four = each(tied, 4, "rod and vertex of each end");
      ends.emplace_back(at_vertex(four[0], four[1], structure),
                        at_vertex(four[2], four[3], structure));
    }
    return ends;
  }
  const int rods = static_cast<int>(structure.rods.size());
  if (!root.has("spring_rod_anchor") && rods > 1)
    root.fail("the key \"spring_rod_anchor\" is missing: which rods the springs are tied to");
  const auto places = root["restVars"].items();
  std::vector<JsonValue> pairs;
  if (root.has("spring_rod_anchor")) pairs = each(root["spring_rod_anchor"], count, "spring");
  for (int c = 0; c < count; ++c) {
    std::pair<int, int> on{0, 0};
    if (!pairs.empty()) {
      const auto two = each(pairs[c], 2, "end");
      on = {whole(two[0], rods, "rod"), whole(two[1], rods, "rod")};
    }
    ends.emplace_back(along(places[count + 2 * c], on.first, structure),
                      along(places[count + 2 * c + 1], on.second, structure));
  }
  return ends;
}

void read_cables(const JsonValue& root, model::Design& design) {
  const int count = root["numSprings"].integer(0);
  const int type = root["restVarType"].integer(0);
  if (type != static_cast<int>(Springs::on_vertices) &&
      type != static_cast<int>(Springs::along_rods))
    root["restVarType"].fail(
        "expected 0 or 3, found " + std::to_string(type) +
        ", with which the file holds only a part of stiffnesses and places of the springs");
  const Springs springs{type};
  const auto variables =
      each(root["restVars"], springs == Springs::on_vertices ? count : 3L * count, "variable");
  const auto lengths = each(root["springRestLengths"], count, "spring");
  const auto ends = read_ends(root, springs, count, design.structure);
  for (int c = 0; c < count; ++c)
    design.structure.cables.push_back({.a = ends[c].first,
                                       .b = ends[c].second,
                                       .stiffness = variables[c].positive(),
                                       .rest_length = lengths[c].at_least_zero()});
}

// The vertex of the rod at arc length s; not set: it is between two.
std::optional<int> vertex_at(const der::Rod& rod, double s) {
  double at = 0;
  for (int v = 0; v < rod.vertices(); ++v) {
    if (std::abs(s - at) <= 1e-9 * rod.length()) return v;
    if (v < rod.edges()) at += rod.rest_lengths[v];
  }
  return std::nullopt;
}

bool is_on(const springs::End& end, int rod) {
  const auto* on = std::get_if<springs::OnRod>(&end);
  return on && on->rod == rod;
}

bool is_frame(const model::Design& design, int rod) {
  const der::Rod& frame = design.structure.rods[rod];
  const double moved =
      (design.pose[rod] - design.target[rod]).colwise().norm().maxCoeff() / frame.length();
  bool pulled = false;
  for (const springs::Cable& cable : design.structure.cables)
    for (const springs::End& end : {cable.a, cable.b}) {
      if (!is_on(end, rod)) continue;
      if (!vertex_at(frame, std::get<springs::OnRod>(end).s)) return false;
      pulled = true;
    }
  return !frame.closed && pulled && moved <= 1e-12;
}

// The rod's vertices become anchors, and the rods after it move up.
void take_as_anchors(int rod, model::Design& design) {
  model::Structure& structure = design.structure;
  const der::Rod frame = structure.rods[rod];
  const int first = static_cast<int>(structure.anchors.cols());
  structure.anchors.conservativeResize(3, first + frame.vertices());
  structure.anchors.rightCols(frame.vertices()) = design.target[rod];
  for (springs::Cable& cable : structure.cables)
    for (springs::End* end : {&cable.a, &cable.b}) {
      auto* on = std::get_if<springs::OnRod>(end);
      if (!on) continue;
      if (on->rod == rod)
        *end = springs::AtAnchor{first + *vertex_at(frame, on->s)};
      else if (on->rod > rod)
        --on->rod;
    }
  structure.rods.erase(structure.rods.begin() + rod);
  design.target.erase(design.target.begin() + rod);
  design.pose.erase(design.pose.begin() + rod);
}

}  // namespace

bool is_program_state(const nlohmann::json& content) {
  return content.is_object() && content.contains("numOpenRods") && content.contains("defoVars");
}

model::Design design_from_program_state(const JsonValue& root) {
  model::Design design;
  read_rods(root, design);
  read_cables(root, design);
  for (int r = static_cast<int>(design.structure.rods.size()) - 1; r >= 0; --r)
    if (design.structure.rods.size() > 1 && is_frame(design, r)) take_as_anchors(r, design);
  design.structure.planar = are_flat(design.target);
  build_in_pose(design, root["springRestLengths"]);
  return design;
}

}  // namespace tencer::io
