#include <algorithm>
#include <cmath>
#include <numeric>
#include <tencer/core/error.hpp>
#include <tencer/model/structure.hpp>

namespace tencer::model {

void validate(const Structure& structure) {
  core::require(!structure.rods.empty(), "structure: needs at least one rod");
  const int rods = static_cast<int>(structure.rods.size());
  for (const auto& rod : structure.rods) der::validate(rod);
  core::require(structure.materials.empty() || structure.materials.size() == structure.rods.size(),
                "structure: needs a material for each rod, or none at all");
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

std::vector<geometry::ArcLength> arc_lengths(const Structure& structure) {
  std::vector<geometry::ArcLength> along;
  along.reserve(structure.rods.size());
  for (const auto& rod : structure.rods) along.emplace_back(rod.rest_lengths, rod.closed);
  return along;
}

double total_length(const Structure& structure) {
  double length = 0;
  for (const auto& rod : structure.rods) length += rod.length();
  return length;
}

bool is_external(const springs::Cable& cable) {
  return std::holds_alternative<springs::AtAnchor>(cable.a) ||
         std::holds_alternative<springs::AtAnchor>(cable.b);
}

std::vector<int> components(const Structure& structure) {
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

}  // namespace tencer::model
