#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/ground_structure/candidates.hpp>
#include <tencer/model/clearance.hpp>

namespace tencer::ground_structure {
namespace {

struct Node {
  int rod = 0;
  int vertex = 0;
  double s = 0.0;
  bool held = false;
};

bool is_held(const model::Structure& structure, int rod, int vertex) {
  std::array<bool, 3> held{false, false, structure.planar};
  for (const auto& pin : structure.pins)
    if (pin.rod == rod && pin.vertex == vertex)
      for (int axis = 0; axis < 3; ++axis) held[axis] = held[axis] || pin.axes[axis];
  return held[0] && held[1] && held[2];
}

// Cables end at every so many vertices of a rod, so that candidates do not grow with the square of
// their number.
std::vector<int> strides(const model::Structure& structure) {
  constexpr int most_of_rod = 400;
  constexpr int most_of_all = 1500;
  int all = 0;
  for (const auto& rod : structure.rods) all += std::min(rod.vertices(), most_of_rod);
  std::vector<int> result;
  for (const auto& rod : structure.rods) {
    const int kept = std::min(rod.vertices(), most_of_rod);
    const int most = std::max(2, all > most_of_all ? kept * most_of_all / all : kept);
    result.push_back((rod.vertices() + most - 1) / most);
  }
  return result;
}

std::vector<Node> attachable_vertices(const model::Structure& structure, const model::Rules& rules,
                                      const std::vector<int>& strides) {
  const auto along = model::arc_lengths(structure);
  std::vector<Node> nodes;
  for (int rod = 0; rod < static_cast<int>(structure.rods.size()); ++rod) {
    for (int vertex = 0; vertex < structure.rods[rod].vertices(); vertex += strides[rod]) {
      const double s = along[rod].knots()[vertex];
      if (place_allowed(rules, structure, rod, s))
        nodes.push_back({rod, vertex, s, is_held(structure, rod, vertex)});
    }
  }
  return nodes;
}

std::string name_of(const Node& node) {
  return "vertex " + std::to_string(node.vertex) + " of rods[" + std::to_string(node.rod) + "]";
}

core::Error coincidence(const Node& node, const std::string& other, const std::string& remedy) {
  return {.where = "rods[" + std::to_string(node.rod) + "]",
          .message = name_of(node) + " and " + other +
                     " coincide, so a cable between them has no length; " + remedy};
}

// Collects the cables that are allowed between nodes at `positions`.
class Collector {
 public:
  Collector(const model::Structure& structure, const std::vector<Eigen::Matrix3Xd>& positions,
            const model::Rules& rules)
      : structure_(structure),
        positions_(positions),
        rules_(rules),
        strides_(strides(structure)),
        nodes_(attachable_vertices(structure, rules, strides_)),
        // Lengths change a little until the design is done; this leaves room for it.
        max_length_(0.99 * rules.max_cable_length) {
    for (const auto& rod : structure.rods)
      touching_ = std::min(touching_, 1e-6 * rod.rest_lengths.minCoeff());
  }

  // An error when the ends of an allowed cable are the same point.
  std::optional<core::Error> add_between_rods() {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (std::size_t j = i + 1; j < nodes_.size(); ++j) {
        const Node& a = nodes_[i];
        const Node& b = nodes_[j];
        if (!pair_allowed(rules_, a.rod, b.rod)) continue;
        if ((a.held && b.held) || are_neighbours(a, b)) continue;
        if (!add({.a = springs::OnRod{a.rod, a.s}, .b = springs::OnRod{b.rod, b.s}},
                 (at(b) - at(a)).norm()))
          return coincidence(a, name_of(b), "use a target that keeps clear of itself");
      }
    return std::nullopt;
  }

  std::optional<core::Error> add_to_anchors() {
    for (const Node& a : nodes_)
      for (int anchor = 0; anchor < structure_.anchors.cols() && !a.held; ++anchor)
        if (!add({.a = springs::OnRod{a.rod, a.s}, .b = springs::AtAnchor{anchor}},
                 (structure_.anchors.col(anchor) - at(a)).norm()))
          return coincidence(a, "anchors[" + std::to_string(anchor) + "]",
                             "pin the vertex, or move the anchor");
    return std::nullopt;
  }

  // An error when there are none by the other rules.
  core::Expected<std::vector<springs::Cable>> take() {
    leave_out_unwanted();
    if (!cables_.empty()) {
      keep_clear();
      return std::move(cables_);
    }
    std::string why =
        "the pairs of rods leave none; allow cables between more rods, within a rod, or to anchors";
    if (any_pair_) why = "every one would be longer than the longest cable allowed";
    if (nodes_.empty()) why = "the forbidden arcs cover every vertex";
    return core::Error{.where = {}, .message = "no cables are allowed: " + why};
  }

 private:
  void leave_out_unwanted() {
    if (rules_.unwanted.empty()) return;
    const auto along = model::arc_lengths(structure_);
    std::erase_if(cables_, [&](const springs::Cable& cable) {
      return model::is_unwanted(rules_, along, cable);
    });
  }

  // Leaves out the cables that rods are in the way of.
  void keep_clear() {
    if (!rules_.gaps) return;
    const model::State state = make_state(structure_, positions_);
    const model::CablePasses passes(structure_, state, *rules_.gaps);
    std::erase_if(cables_, [&](const springs::Cable& cable) { return !passes.clear(cable); });
  }

  // false: it has no length.
  bool add(const springs::Cable& cable, double length) {
    any_pair_ = true;
    if (length > max_length_) return true;
    if (length < touching_) return false;
    cables_.push_back(cable);
    return true;
  }

  bool are_neighbours(const Node& a, const Node& b) const {
    if (a.rod != b.rod) return false;
    const der::Rod& rod = structure_.rods[a.rod];
    const int apart = std::abs(a.vertex - b.vertex);
    return apart <= strides_[a.rod] || (rod.closed && rod.vertices() - apart <= strides_[a.rod]);
  }

  Eigen::Vector3d at(const Node& node) const { return positions_[node.rod].col(node.vertex); }

  const model::Structure& structure_;
  const std::vector<Eigen::Matrix3Xd>& positions_;
  const model::Rules& rules_;
  std::vector<int> strides_;
  std::vector<Node> nodes_;
  double max_length_;
  // Places nearer than this are the same: a cable of such a length has no dependable direction.
  double touching_ = std::numeric_limits<double>::infinity();
  std::vector<springs::Cable> cables_;
  bool any_pair_ = false;
};

}  // namespace

core::Expected<std::vector<springs::Cable>> candidates(
    const model::Structure& structure, const std::vector<Eigen::Matrix3Xd>& positions,
    const model::Rules& rules) {
  validate(rules, structure);
  core::require(positions.size() == structure.rods.size(),
                "candidates: positions must have one entry per rod");
  for (std::size_t rod = 0; rod < positions.size(); ++rod)
    core::require(positions[rod].cols() == structure.rods[rod].vertices(),
                  "candidates: positions must have one column per vertex");
  Collector collector(structure, positions, rules);
  if (auto error = collector.add_between_rods()) return *error;
  if (rules.external)
    if (auto error = collector.add_to_anchors()) return *error;
  return collector.take();
}

}  // namespace tencer::ground_structure
