#include <algorithm>
#include <tencer/sparsify/network.hpp>
#include <tencer/springs/law.hpp>

namespace tencer::sparsify {

Eigen::VectorXd cable_lengths(const Network& network) {
  const auto& structure = network.structure;
  std::vector<geometry::ArcLength> along;
  for (const auto& rod : structure.rods) along.emplace_back(rod.rest_lengths, rod.closed);
  Eigen::VectorXd lengths(static_cast<Eigen::Index>(structure.cables.size()));
  for (Eigen::Index i = 0; i < lengths.size(); ++i)
    lengths[i] = equilibrium::span_of(
                     springs::stencil(structure.cables[i], along, structure.anchors), network.state)
                     .norm();
  return lengths;
}

Eigen::VectorXd cable_tensions(const Network& network) {
  Eigen::VectorXd tensions = cable_lengths(network);
  for (Eigen::Index i = 0; i < tensions.size(); ++i)
    tensions[i] = springs::tension(network.structure.cables[i], tensions[i]);
  return tensions;
}

std::vector<int> idle_cables(const Network& network) {
  std::vector<int> idle;
  if (network.structure.cables.empty()) return idle;
  const Eigen::VectorXd tensions = cable_tensions(network);
  const double least = 1e-9 * std::max(tensions.maxCoeff(), 0.0);
  for (Eigen::Index i = 0; i < tensions.size(); ++i)
    if (!(tensions[i] > least)) idle.push_back(static_cast<int>(i));
  return idle;
}

}  // namespace tencer::sparsify
