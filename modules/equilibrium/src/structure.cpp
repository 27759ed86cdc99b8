#include <algorithm>
#include <cmath>
#include <numeric>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/structure.hpp>

namespace tencer::equilibrium {

void validate(const Structure& structure) {
  core::require(!structure.rods.empty(), "structure: needs at least one rod");
  const int rods = static_cast<int>(structure.rods.size());
  for (const auto& rod : structure.rods) der::validate(rod);
  core::require(structure.anchors.allFinite(), "structure: anchors must be finite");
  for (const auto& cable : structure.cables)
    springs::validate(cable, rods, static_cast<int>(structure.anchors.cols()));
  for (const Pin& pin : structure.pins)
    core::require(pin.rod >= 0 && pin.rod < rods && pin.vertex >= 0 &&
                      pin.vertex < structure.rods[pin.rod].vertices(),
                  "structure: a pin must name a rod and a vertex that exist");
  const auto check_load = [&](int rod, const Eigen::Vector3d& force, double s) {
    core::require(rod >= 0 && rod < rods && force.allFinite() && std::isfinite(s),
                  "structure: a load must be finite and name a rod that exists");
  };
  for (const PointLoad& load : structure.point_loads) check_load(load.rod, load.force, load.s);
  for (const LineLoad& load : structure.line_loads)
    check_load(load.rod, load.force_per_length, 0.0);
}

State make_state(const Structure& structure, const std::vector<Eigen::Matrix3Xd>& positions) {
  core::require(positions.size() == structure.rods.size(),
                "make_state: needs the positions of every rod");
  State state;
  for (std::size_t r = 0; r < positions.size(); ++r)
    state.push_back(der::make_state(structure.rods[r], positions[r]));
  return state;
}

Eigen::Vector3d span_of(const springs::Stencil& stencil, const State& state) {
  return springs::span_of(stencil, [&](int rod, int vertex) { return state[rod].x.col(vertex); });
}

std::vector<int> groups(const Structure& structure) {
  std::vector<int> parent(structure.rods.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int rod) {
    while (parent[rod] != rod) rod = parent[rod] = parent[parent[rod]];
    return rod;
  };
  for (const auto& cable : structure.cables) {
    const auto* a = std::get_if<springs::OnRod>(&cable.a);
    const auto* b = std::get_if<springs::OnRod>(&cable.b);
    if (a && b) parent[std::max(root(a->rod), root(b->rod))] = std::min(root(a->rod), root(b->rod));
  }
  std::vector<int> number(parent.size());
  int count = 0;
  for (int rod = 0; rod < static_cast<int>(parent.size()); ++rod)
    number[rod] = root(rod) == rod ? count++ : number[root(rod)];
  return number;
}

}  // namespace tencer::equilibrium
