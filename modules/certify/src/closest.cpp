#include <algorithm>
#include <cmath>
#include <tencer/certify/closest.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/model/clearance.hpp>

namespace tencer::certify {
namespace {

using Eigen::Vector3d;

// Keeps the nearer one.
template <class Apart>
void keep(std::optional<Apart>& nearest, const Apart& found) {
  if (!nearest || found.distance < nearest->distance) nearest = found;
}

struct Edge {
  int rod = 0;
  Vector3d a = Vector3d::Zero();
  Vector3d b = Vector3d::Zero();
  double s = 0.0;  // of its start, at rest
  double length = 0.0;
};

std::vector<Edge> edges_of(const model::Structure& structure, const model::State& state) {
  std::vector<Edge> edges;
  for (int r = 0; r < static_cast<int>(state.size()); ++r) {
    const auto& x = state[r].x;
    double s = 0;
    for (int j = 0; j < structure.rods[r].edges(); ++j) {
      const double length = structure.rods[r].rest_lengths[j];
      edges.push_back({r, x.col(j), x.col((j + 1) % x.cols()), s, length});
      s += length;
    }
  }
  return edges;
}

// Whether two places of one rod belong to strands of it.
bool are_strands(const Edge& one, double s_a, const Edge& other, double s_b, double distance,
                 const der::Rod& rod) {
  double along = std::abs(s_a - s_b);
  if (rod.closed) along = std::min(along, rod.length() - along);
  return along > 2 * distance + one.length + other.length;
}

std::optional<CableRodApart> closest_cable_rod(const model::Structure& structure,
                                               const model::State& state,
                                               const std::vector<double>& radii) {
  const model::CablePasses passes(structure, state);
  const auto along = model::arc_lengths(structure);
  std::optional<CableRodApart> nearest;
  for (int c = 0; c < static_cast<int>(structure.cables.size()); ++c)
    for (const model::CablePass& pass : passes.of(structure.cables[c], c)) {
      const double distance = pass.distance - radii[pass.rod];
      // Where it has just left its rod it is near it, which is no fault unless it is within.
      if (pass.beside_end >= 0 && distance > 0) continue;
      keep(nearest,
           {distance, c, pass.rod,
            along[pass.rod].knots()[pass.edge] + pass.t * along[pass.rod].edge_length(pass.edge)});
    }
  return nearest;
}

// Whether two ends are at one place, a rod's within six radii.
bool meet(const springs::End& one, const springs::End& other, const model::Structure& structure,
          const std::vector<double>& radii) {
  constexpr double own_radii = 6;
  if (one.index() != other.index()) return false;
  if (const auto* anchor = std::get_if<springs::AtAnchor>(&one))
    return anchor->anchor == std::get<springs::AtAnchor>(other).anchor;
  const auto& a = std::get<springs::OnRod>(one);
  const auto& b = std::get<springs::OnRod>(other);
  if (a.rod != b.rod) return false;
  double apart = std::abs(a.s - b.s);
  const der::Rod& rod = structure.rods[a.rod];
  if (rod.closed) apart = std::min(apart, std::abs(rod.length() - apart));
  return apart <= own_radii * radii[a.rod];
}

std::optional<CablesApart> closest_cables(const model::Structure& structure,
                                          const model::State& state,
                                          const std::vector<double>& radii) {
  const Eigen::Matrix3Xd ends = model::cable_ends(structure, model::positions_of(state));
  const auto& cables = structure.cables;
  std::optional<CablesApart> nearest;
  for (int c = 0; c < static_cast<int>(cables.size()); ++c)
    for (int d = c + 1; d < static_cast<int>(cables.size()); ++d) {
      bool joined = false;
      for (const springs::End* one : {&cables[c].a, &cables[c].b})
        for (const springs::End* other : {&cables[d].a, &cables[d].b})
          joined = joined || meet(*one, *other, structure, radii);
      if (joined) continue;
      keep(nearest, {geometry::segment_approach(ends.col(2 * c), ends.col(2 * c + 1),
                                                ends.col(2 * d), ends.col(2 * d + 1))
                         .distance,
                     c, d});
    }
  return nearest;
}

std::optional<MarksApart> closest_marks(const model::Structure& structure) {
  constexpr double same = 1e-9;  // of the rod's length
  std::optional<MarksApart> nearest;
  for (const auto& [first, second, rod, apart] :
       model::neighbouring_marks(structure.cables, model::arc_lengths(structure)))
    if (apart > same * structure.rods[rod].length()) keep(nearest, {apart, rod, first.s, second.s});
  return nearest;
}

}  // namespace

std::vector<RodsApart> closest_rods(const model::Structure& structure, const model::State& state) {
  const std::vector<double> radii = model::outer_radii(structure);
  const std::vector<Edge> edges = edges_of(structure, state);
  const std::size_t rods = structure.rods.size();
  std::vector<std::optional<RodsApart>> nearest(rods * rods);
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Edge& one = edges[i];
      const Edge& other = edges[j];
      const double thick = radii[one.rod] + radii[other.rod];
      auto& known =
          nearest[static_cast<std::size_t>(one.rod) * rods + static_cast<std::size_t>(other.rod)];
      // The balls around the two edges are already too far apart.
      const double between = ((one.a + one.b) - (other.a + other.b)).norm() / 2 -
                             (one.b - one.a).norm() / 2 - (other.b - other.a).norm() / 2;
      if (known && between - thick >= known->distance) continue;
      const auto found = geometry::segment_approach(one.a, one.b, other.a, other.b);
      const double s_a = one.s + found.t_a * one.length;
      const double s_b = other.s + found.t_b * other.length;
      if (one.rod == other.rod &&
          !are_strands(one, s_a, other, s_b, found.distance, structure.rods[one.rod]))
        continue;
      keep(known, RodsApart{found.distance - thick, one.rod, s_a, other.rod, s_b});
    }
  std::vector<RodsApart> result;
  for (const auto& apart : nearest)
    if (apart) result.push_back(*apart);
  return result;
}

Closest closest(const model::Structure& structure, const model::State& state) {
  const std::vector<double> radii = model::outer_radii(structure);
  std::optional<RodsApart> rods;
  for (const RodsApart& apart : closest_rods(structure, state)) keep(rods, apart);
  return {.rods = rods,
          .cable_rod = closest_cable_rod(structure, state, radii),
          .cables = closest_cables(structure, state, radii),
          .marks = closest_marks(structure)};
}

}  // namespace tencer::certify
