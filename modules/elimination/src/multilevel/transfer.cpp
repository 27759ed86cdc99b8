#include "multilevel/transfer.hpp"

#include <tencer/geometry/sampling.hpp>
#include <tencer/network/rest_length.hpp>
#include <tencer/springs/law.hpp>
#include <utility>

namespace tencer::elimination {
namespace {

geometry::ArcLength arc_of(const der::Rod& rod) { return {rod.rest_lengths, rod.closed}; }

geometry::ArcLength equal_edges(const der::Rod& rod, double length) {
  return {Eigen::VectorXd::Constant(rod.edges(), length / rod.edges()), rod.closed};
}

// The point with the same edge and the same part of it.
double same_point(double s, const geometry::ArcLength& from, const geometry::ArcLength& to) {
  const auto [edge, t] = from.locate(s);
  return to.knots()[edge] + t * to.edge_length(edge);
}

void transfer(springs::End& end, const std::vector<ResolutionMap>& rods) {
  if (auto* on = std::get_if<springs::OnRod>(&end)) on->s = rods[on->rod].place(on->s);
}

}  // namespace

ResolutionMap::ResolutionMap(const der::Rod& from, const der::Rod& to)
    : from_(arc_of(from)), to_(arc_of(to)), common_from_(from_), common_to_(to_) {
  if (from.edges() < to.edges()) common_from_ = equal_edges(from, to_.length());
  if (to.edges() < from.edges()) common_to_ = equal_edges(to, from_.length());
}

double ResolutionMap::place(double s) const {
  return same_point(same_point(s, from_, common_from_), common_to_, to_);
}

Eigen::Matrix3Xd ResolutionMap::positions(const Eigen::Matrix3Xd& x) const {
  return geometry::smooth_points(x, common_from_,
                                 common_to_.knots().head(to_.edges() + (to_.closed() ? 0 : 1)));
}

void transfer(springs::Cable& cable, const std::vector<ResolutionMap>& rods) {
  transfer(cable.a, rods);
  transfer(cable.b, rods);
}

std::vector<ResolutionMap> resolution_maps(const std::vector<der::Rod>& from,
                                           const std::vector<der::Rod>& to) {
  std::vector<ResolutionMap> result;
  for (std::size_t r = 0; r < from.size(); ++r) result.emplace_back(from[r], to[r]);
  return result;
}

network::Network transferred(const network::Network& network, const model::Structure& bare) {
  const auto& rods = network.structure.rods;
  const auto maps = resolution_maps(rods, bare.rods);
  std::vector<Eigen::Matrix3Xd> positions;
  for (std::size_t r = 0; r < rods.size(); ++r)
    positions.push_back(maps[r].positions(network.state[r].x));
  network::Network result{.structure = bare, .state = make_state(bare, positions)};
  for (std::size_t r = 0; r < rods.size(); ++r)
    if (rods[r].edges() == bare.rods[r].edges()) result.state[r] = network.state[r];
  const Eigen::VectorXd tensions = cable_tensions(network);
  const auto along = model::arc_lengths(bare);
  for (std::size_t c = 0; c < network.structure.cables.size(); ++c) {
    springs::Cable cable = network.structure.cables[c];
    transfer(cable, maps);
    const double length =
        model::span_of(springs::stencil(cable, along, bare.anchors), result.state).norm();
    result.structure.cables.push_back(springs::with_tension(
        cable, length, tensions[static_cast<Eigen::Index>(c)], network::stiff_rest_ratio));
  }
  return result;
}

symmetry::Group transferred(const symmetry::Group& group, const std::vector<der::Rod>& from,
                            const std::vector<der::Rod>& to) {
  const auto maps = resolution_maps(from, to);
  symmetry::Group result = group;
  for (std::size_t r = 0; r < to.size(); ++r) result.rods[r] = maps[r].to();
  for (auto& operation : result.operations)
    for (std::size_t r = 0; r < to.size(); ++r) {
      auto& map = operation.rods[r];
      map.rate *= maps[map.rod].factor() / maps[r].factor();
      map.offset = maps[map.rod].place(map.offset);
    }
  return result;
}

}  // namespace tencer::elimination
