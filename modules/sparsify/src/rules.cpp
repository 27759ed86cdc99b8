#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/sparsify/rules.hpp>

namespace tencer::sparsify {
namespace {

geometry::ArcLength arc_length_of(const equilibrium::Structure& structure, int rod) {
  return {structure.rods[rod].rest_lengths, structure.rods[rod].closed};
}

// An arc as the interval that starts in [0, L); it may reach beyond L on a closed rod.
Interval unrolled(const Arc& arc, const geometry::ArcLength& along) {
  if (!along.closed()) return {arc.from, arc.to};
  const double from = along.wrap(arc.from);
  double span = arc.to - arc.from;
  if (span < 0) span += along.length();
  return {from, from + span};
}

struct Node {
  int rod = 0;
  int vertex = 0;
  double s = 0.0;
  bool held = false;
};

bool is_held(const equilibrium::Structure& structure, int rod, int vertex) {
  std::array<bool, 3> held{false, false, structure.planar};
  for (const auto& pin : structure.pins)
    if (pin.rod == rod && pin.vertex == vertex)
      for (int axis = 0; axis < 3; ++axis) held[axis] = held[axis] || pin.axes[axis];
  return held[0] && held[1] && held[2];
}

std::vector<Node> attachable_vertices(const equilibrium::Structure& structure, const Rules& rules) {
  std::vector<Node> nodes;
  for (int rod = 0; rod < static_cast<int>(structure.rods.size()); ++rod) {
    const auto along = arc_length_of(structure, rod);
    for (int vertex = 0; vertex < structure.rods[rod].vertices(); ++vertex) {
      const double s = along.knots()[vertex];
      if (place_allowed(rules, structure, rod, s))
        nodes.push_back({rod, vertex, s, is_held(structure, rod, vertex)});
    }
  }
  return nodes;
}

bool are_neighbours(const equilibrium::Structure& structure, const Node& a, const Node& b) {
  if (a.rod != b.rod) return false;
  const auto& rod = structure.rods[a.rod];
  const int apart = std::abs(a.vertex - b.vertex);
  return apart == 1 || (rod.closed && apart == rod.vertices() - 1);
}

std::string name_of(const Node& node) {
  return "vertex " + std::to_string(node.vertex) + " of rods[" + std::to_string(node.rod) + "]";
}

core::Error coincidence(const Node& node, const std::string& other, const std::string& remedy) {
  return {.where = "rods[" + std::to_string(node.rod) + "]",
          .message = name_of(node) + " and " + other +
                     " coincide, so a cable between them has no length; " + remedy};
}

}  // namespace

void validate(const Rules& rules, const equilibrium::Structure& structure) {
  const int rods = static_cast<int>(structure.rods.size());
  const auto exists = [&](int rod) { return rod >= 0 && rod < rods; };
  if (rules.pairs)
    for (const auto& pair : *rules.pairs)
      core::require(exists(pair.a) && exists(pair.b), "Rules::pairs: no such rod");
  for (const auto& arc : rules.forbidden) {
    core::require(exists(arc.rod), "Rules::forbidden: no such rod");
    core::require(std::isfinite(arc.from) && std::isfinite(arc.to),
                  "Rules::forbidden: from and to must be finite");
    core::require(structure.rods[arc.rod].closed || arc.from <= arc.to,
                  "Rules::forbidden: from must not exceed to on an open rod");
    core::require(std::abs(arc.to - arc.from) <= structure.rods[arc.rod].length(),
                  "Rules::forbidden: longer than the rod");
  }
  core::require(rules.longest > 0, "Rules::longest must be positive");
}

bool pair_allowed(const Rules& rules, int rod_a, int rod_b) {
  if (!rules.pairs) return true;
  return std::ranges::any_of(*rules.pairs, [&](const RodPair& pair) {
    return (pair.a == rod_a && pair.b == rod_b) || (pair.a == rod_b && pair.b == rod_a);
  });
}

bool place_allowed(const Rules& rules, const equilibrium::Structure& structure, int rod, double s) {
  const auto along = arc_length_of(structure, rod);
  const double at = along.wrap(s);
  return std::ranges::none_of(rules.forbidden, [&](const Arc& arc) {
    if (arc.rod != rod) return false;
    const Interval span = unrolled(arc, along);
    return (at >= span.lower && at <= span.upper) ||
           (along.closed() && at + along.length() <= span.upper);
  });
}

Interval sliding_interval(const Rules& rules, const equilibrium::Structure& structure, int rod,
                          double s) {
  const auto along = arc_length_of(structure, rod);
  const double length = along.length();
  // Forbidden arcs include their ends, so bounds stay clear of them by a margin that is small
  // against any edge and large against rounding.
  const double clear = 1e-9 * length;
  Interval free = along.closed() ? Interval{s - length, s + length} : Interval{0.0, length};
  for (const auto& arc : rules.forbidden) {
    if (arc.rod != rod) continue;
    const Interval span = unrolled(arc, along);
    const double turns = along.closed() ? std::floor(s / length) * length : 0.0;
    for (const int k : {-2, -1, 0, 1}) {
      const double offset = along.closed() ? turns + k * length : 0.0;
      if (span.upper + offset < s) free.lower = std::max(free.lower, span.upper + offset + clear);
      if (span.lower + offset > s) free.upper = std::min(free.upper, span.lower + offset - clear);
    }
  }
  return {std::min(free.lower, s), std::max(free.upper, s)};
}

core::Expected<std::vector<springs::Cable>> candidates(
    const equilibrium::Structure& structure, const std::vector<Eigen::Matrix3Xd>& positions,
    const Rules& rules) {
  validate(rules, structure);
  core::require(positions.size() == structure.rods.size(),
                "candidates: positions must have one entry per rod");
  for (std::size_t rod = 0; rod < positions.size(); ++rod)
    core::require(positions[rod].cols() == structure.rods[rod].vertices(),
                  "candidates: positions must have one column per vertex");

  const auto nodes = attachable_vertices(structure, rules);
  const auto at = [&](const Node& node) { return positions[node.rod].col(node.vertex); };
  // Against this two places are the same: a cable of such a length has no dependable direction.
  double touching = std::numeric_limits<double>::infinity();
  for (const auto& rod : structure.rods)
    touching = std::min(touching, 1e-6 * rod.rest_lengths.minCoeff());

  // Lengths change a little until the design is done; this leaves room for it.
  const double longest = 0.99 * rules.longest;
  std::vector<springs::Cable> cables;
  bool any_pair = false;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = i + 1; j < nodes.size(); ++j) {
      const Node& a = nodes[i];
      const Node& b = nodes[j];
      if (!pair_allowed(rules, a.rod, b.rod)) continue;
      if ((a.held && b.held) || are_neighbours(structure, a, b)) continue;
      any_pair = true;
      const double length = (at(b) - at(a)).norm();
      if (length > longest) continue;
      if (length < touching)
        return coincidence(a, name_of(b), "use a target that keeps clear of itself");
      cables.push_back({.a = springs::OnRod{a.rod, a.s}, .b = springs::OnRod{b.rod, b.s}});
    }
  if (rules.external)
    for (const Node& a : nodes)
      for (int anchor = 0; anchor < structure.anchors.cols() && !a.held; ++anchor) {
        any_pair = true;
        const double length = (structure.anchors.col(anchor) - at(a)).norm();
        if (length > longest) continue;
        if (length < touching)
          return coincidence(a, "anchors[" + std::to_string(anchor) + "]",
                             "pin the vertex, or move the anchor");
        cables.push_back({.a = springs::OnRod{a.rod, a.s}, .b = springs::AtAnchor{anchor}});
      }
  if (!cables.empty()) return cables;
  if (nodes.empty())
    return core::Error{.where = {},
                       .message = "no cables are allowed: the forbidden arcs cover every vertex"};
  if (any_pair)
    return core::Error{
        .where = {},
        .message =
            "no cables are allowed: every one would be longer than the longest cable allowed"};
  return core::Error{
      .where = {},
      .message =
          "no cables are allowed: the pairs of rods leave none; allow cables between more "
          "rods, within a rod, or to anchors"};
}

}  // namespace tencer::sparsify
