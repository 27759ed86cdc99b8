#include <algorithm>
#include <limits>
#include <numbers>
#include <tencer/ground_structure/dense_springs.hpp>

namespace tencer::ground_structure {

std::vector<springs::Cable> dense_springs(const model::Structure& structure,
                                          const std::vector<Eigen::Matrix3Xd>& positions,
                                          std::vector<springs::Cable> candidates, double factor) {
  const auto state = model::make_state(structure, positions);
  const auto along = model::arc_lengths(structure);
  std::vector<double> stiffness;
  for (const auto& rod : structure.rods)
    stiffness.push_back(factor * 4 / std::numbers::pi * rod.section.EA / rod.length());
  const auto softer = [&](double so_far, const springs::End& end) {
    const auto* on_rod = std::get_if<springs::OnRod>(&end);
    return on_rod ? std::min(so_far, stiffness[on_rod->rod]) : so_far;
  };
  for (auto& cable : candidates) {
    cable.stiffness = softer(softer(std::numeric_limits<double>::infinity(), cable.a), cable.b);
    cable.rest_length =
        model::span_of(springs::stencil(cable, along, structure.anchors), state).norm();
  }
  return candidates;
}

}  // namespace tencer::ground_structure
