#include <algorithm>
#include <tencer/network/network.hpp>
#include <tencer/springs/law.hpp>

namespace tencer::network {

int cable_count(const Network& network) {
  return static_cast<int>(network.structure.cables.size());
}

Eigen::VectorXd cable_lengths(const Network& network) {
  return model::cable_lengths(network.structure, network.state);
}

Eigen::VectorXd cable_tensions(const Network& network) {
  Eigen::VectorXd tensions = cable_lengths(network);
  for (Eigen::Index i = 0; i < tensions.size(); ++i)
    tensions[i] = springs::tension(network.structure.cables[i], tensions[i]);
  return tensions;
}

Eigen::VectorXd force_densities(const Network& network) {
  return cable_tensions(network).cwiseQuotient(cable_lengths(network));
}

std::vector<int> idle_cables(const Network& network) {
  std::vector<int> idle;
  if (network.structure.cables.empty()) return idle;
  const Eigen::VectorXd tensions = cable_tensions(network);
  const double min_tension = 1e-9 * std::max(tensions.maxCoeff(), 0.0);
  for (Eigen::Index i = 0; i < tensions.size(); ++i)
    if (!(tensions[i] > min_tension)) idle.push_back(static_cast<int>(i));
  return idle;
}

}  // namespace tencer::network
