#include <algorithm>
#include <numbers>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/sparsify/dense.hpp>

namespace tencer::sparsify {

std::vector<springs::Cable> dense_springs(const equilibrium::Structure& structure,
                                          const std::vector<Eigen::Matrix3Xd>& positions,
                                          std::vector<springs::Cable> candidates) {
  const auto state = equilibrium::make_state(structure, positions);
  std::vector<geometry::ArcLength> along;
  std::vector<double> stiffness;
  for (const auto& rod : structure.rods) {
    along.emplace_back(rod.rest_lengths, rod.closed);
    stiffness.push_back(100 * 4 / std::numbers::pi * rod.section.EA / rod.length());
  }
  const auto softer = [&](double so_far, const springs::End& end) {
    const auto* on_rod = std::get_if<springs::OnRod>(&end);
    return on_rod ? std::min(so_far, stiffness[on_rod->rod]) : so_far;
  };
  for (auto& cable : candidates) {
    cable.stiffness = softer(softer(std::numeric_limits<double>::infinity(), cable.a), cable.b);
    cable.rest_length =
        equilibrium::span_of(springs::stencil(cable, along, structure.anchors), state).norm();
  }
  return candidates;
}

}  // namespace tencer::sparsify
