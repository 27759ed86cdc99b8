#include "moves/block.hpp"

#include <algorithm>
#include <set>
#include <tencer/network/rest_length.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <utility>

namespace tencer::elimination {
namespace {

int index_of(const std::vector<int>& rods, int rod) {
  const auto found = std::ranges::find(rods, rod);
  return found == rods.end() ? -1 : static_cast<int>(found - rods.begin());
}

const springs::OnRod* on_rod(const springs::End& end) { return std::get_if<springs::OnRod>(&end); }

enum class Place { inside, outside, between };

Place place_of(const springs::Cable& cable, const std::vector<int>& rods) {
  bool inside = false;
  bool outside = false;
  for (const springs::End* end : {&cable.a, &cable.b})
    if (const auto* on = on_rod(*end)) (index_of(rods, on->rod) >= 0 ? inside : outside) = true;
  if (inside && outside) return Place::between;
  return inside ? Place::inside : Place::outside;
}

Eigen::Vector3d point_on(const network::Network& network, const springs::OnRod& on) {
  const der::Rod& rod = network.structure.rods[on.rod];
  const Eigen::Matrix3Xd& x = network.state[on.rod].x;
  const auto [edge, t] = geometry::ArcLength(rod.rest_lengths, rod.closed).locate(on.s);
  return (1 - t) * x.col(edge) + t * x.col((edge + 1) % x.cols());
}

// The cable with its ends' rods numbered as in the block; ends on other rods become new anchors.
springs::Cable numbered(springs::Cable cable, const network::Network& whole,
                        const std::vector<int>& rods, Eigen::Matrix3Xd& anchors) {
  for (springs::End* end : {&cable.a, &cable.b}) {
    const auto* on = on_rod(*end);
    if (!on) continue;
    if (const int rod = index_of(rods, on->rod); rod >= 0) {
      *end = springs::OnRod{rod, on->s};
    } else {
      const Eigen::Vector3d held = point_on(whole, *on);
      anchors.conservativeResize(Eigen::NoChange, anchors.cols() + 1);
      anchors.rightCols(1) = held;
      *end = springs::AtAnchor{static_cast<int>(anchors.cols()) - 1};
    }
  }
  return cable;
}

// The span of a cable from end a to end b.
Eigen::Vector3d span_of(const network::Network& network, const springs::Cable& cable) {
  const auto point = [&](const springs::End& end) -> Eigen::Vector3d {
    if (const auto* on = on_rod(end)) return point_on(network, *on);
    return network.structure.anchors.col(std::get<springs::AtAnchor>(end).anchor);
  };
  return point(cable.b) - point(cable.a);
}

// The cable, `length` long, with the same force density when it is `now` long, and a rest length of
// rest_ratio times that.
springs::Cable with_rest_ratio(springs::Cable cable, double rest_ratio, double length, double now) {
  const double density = cable.stiffness * (1 - cable.rest_length / length);
  cable.rest_length = rest_ratio * now;
  cable.stiffness = density / (1 - rest_ratio);
  return cable;
}

// What lies on the rods, numbered as in the block.
template <class Thing>
std::vector<Thing> of_rods(const std::vector<Thing>& things, const std::vector<int>& rods) {
  std::vector<Thing> result;
  for (Thing thing : things) {
    thing.rod = index_of(rods, thing.rod);
    if (thing.rod >= 0) result.push_back(thing);
  }
  return result;
}

}  // namespace

Block block_of(const network::Network& whole, const model::Target& target,
               const model::Rules& rules, std::vector<int> rods, double soft_rest_ratio) {
  const model::Structure& all = whole.structure;
  Block block{.rods = std::move(rods)};
  model::Structure& own = block.network.structure;
  own.anchors = all.anchors;
  own.pins = of_rods(all.pins, block.rods);
  own.point_loads = of_rods(all.point_loads, block.rods);
  own.line_loads = of_rods(all.line_loads, block.rods);
  own.planar = all.planar;
  const auto motion = sensitivity::deviation(target, whole.state).motion;
  for (const int r : block.rods) {
    own.rods.push_back(all.rods[r]);
    block.network.state.push_back(whole.state[r]);
    block.target.points.push_back(motion.apply(target.points[r]));
    if (!target.weights.empty()) block.target.weights.push_back(target.weights[r]);
  }
  for (const Place place : {Place::between, Place::inside})
    for (const auto& cable : all.cables)
      if (place_of(cable, block.rods) == place) {
        const double length = span_of(whole, cable).norm();
        own.cables.push_back(numbered(place == Place::between
                                          ? with_rest_ratio(cable, soft_rest_ratio, length, length)
                                          : cable,
                                      whole, block.rods, own.anchors));
      }
  block.fixed_cables = static_cast<int>(own.anchors.cols() - all.anchors.cols());
  block.target.align = target.align && block.fixed_cables == 0;
  block.target.planar = target.planar;
  block.target.views = model::turned(target.views, motion.rotation);
  block.rules = rules;
  block.rules.pairs.reset();
  block.rules.forbidden = of_rods(rules.forbidden, block.rods);
  return block;
}

network::Network with_block(network::Network whole, const Block& block,
                            const network::Network& changed) {
  std::erase_if(whole.structure.cables,
                [&](const auto& cable) { return place_of(cable, block.rods) == Place::inside; });
  const network::Network before = whole;
  for (std::size_t r = 0; r < block.rods.size(); ++r) whole.state[block.rods[r]] = changed.state[r];
  for (auto& cable : whole.structure.cables)
    if (place_of(cable, block.rods) == Place::between)
      cable = with_rest_ratio(cable, network::stiff_rest_ratio, span_of(before, cable).norm(),
                              span_of(whole, cable).norm());
  const auto& cables = changed.structure.cables;
  for (std::size_t c = block.fixed_cables; c < cables.size(); ++c) {
    springs::Cable cable = cables[c];
    for (springs::End* end : {&cable.a, &cable.b})
      if (const auto* on = on_rod(*end)) *end = springs::OnRod{block.rods[on->rod], on->s};
    whole.structure.cables.push_back(cable);
  }
  return whole;
}

std::vector<std::vector<int>> joined_rods(const model::Structure& structure) {
  std::set<std::vector<int>> found;
  std::set<int> alone;
  for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r) alone.insert(r);
  for (const auto& cable : structure.cables) {
    const auto* a = on_rod(cable.a);
    const auto* b = on_rod(cable.b);
    if (!a || !b || a->rod == b->rod) continue;
    found.insert({std::min(a->rod, b->rod), std::max(a->rod, b->rod)});
    alone.erase(a->rod);
    alone.erase(b->rod);
  }
  for (const int r : alone) found.insert({r});
  return {found.begin(), found.end()};
}

}  // namespace tencer::elimination
