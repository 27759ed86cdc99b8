#include <tencer/network/settling.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <utility>

namespace tencer::network {

model::Structure built(const Network& network) {
  model::Structure structure = network.structure;
  const Eigen::VectorXd lengths = cable_lengths(network);
  for (Eigen::Index c = 0; c < lengths.size(); ++c) structure.cables[c].rest_length = lengths[c];
  return structure;
}

Settling settle(const Network& network, model::State start, const model::Target& target,
                const equilibrium::SolveOptions& options) {
  const model::Structure structure = built(network);
  Settling result{
      .equilibrium =
          equilibrium::relax_inextensible(structure, std::move(start), options).equilibrium};
  const auto pose = model::make_target(structure, model::positions_of(network.state));
  const auto deviation = sensitivity::deviation(pose, result.equilibrium.state);
  result.moved_percent = 100 * deviation.max / model::diagonal(target);
  return result;
}

}  // namespace tencer::network
