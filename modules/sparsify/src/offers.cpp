#include "offers.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "target_balance.hpp"

namespace tencer::sparsify {
namespace {

constexpr std::size_t looked_at = 40;  // candidates whose gain is worked out in full

struct Rated {
  int candidate = 0;
  double slope = 0.0;  // of the distance in the cable's tension
};

}  // namespace

std::optional<Offer> best_offer(const Walker& walker, const sensitivity::Target& target,
                                const Rules& rules, std::span<const springs::Cable> candidates) {
  const auto& at = walker.at();
  const auto& system = at.system;
  const sensitivity::Distance distance(target, system, at.state);
  const Eigen::VectorXd adjoint = sensitivity::adjoint(at, distance);
  const auto pulls = pulls_at(system, at.state, candidates, nullptr);
  std::vector<Rated> rated;
  for (int c = 0; c < static_cast<int>(pulls.size()); ++c) {
    const Pull& pull = pulls[c].front();
    if (pull.length > rules.longest) continue;
    double slope = 0;
    for_each_unknown(system, pull, [&](int i, double weight) { slope += weight * adjoint[i]; });
    if (slope < 0) rated.push_back({c, slope});
  }
  std::ranges::sort(rated, {}, [](const Rated& r) { return std::pair(r.slope, r.candidate); });
  if (rated.size() > looked_at) rated.resize(looked_at);

  const Planner plan = walker.planner();
  std::optional<Offer> best;
  double most = 0;
  Eigen::MatrixXd forces =
      Eigen::MatrixXd::Zero(system.size(), static_cast<Eigen::Index>(rated.size()));
  for (Eigen::Index k = 0; k < forces.cols(); ++k) {
    for_each_unknown(system, pulls[rated[k].candidate].front(),
                     [&](int i, double weight) { forces(i, k) -= weight; });
    equilibrium::remove_rigid(at.linearisation.rigid, forces.col(k));
  }
  const Eigen::MatrixXd rates = distance.residual_rates(at.linearisation.solve(std::move(forces)));
  for (Eigen::Index k = 0; k < rates.cols(); ++k) {
    const auto [gain, tension] = plan.gain(rates.col(k));
    if (gain > most) {
      most = gain;
      best = Offer{.cable = candidates[rated[k].candidate], .tension = tension};
    }
  }
  return best;
}

Network with_cable(Network network, springs::Cable cable, double tension) {
  std::vector<geometry::ArcLength> along;
  for (const auto& rod : network.structure.rods) along.emplace_back(rod.rest_lengths, rod.closed);
  const double length =
      equilibrium::span_of(springs::stencil(cable, along, network.structure.anchors), network.state)
          .norm();
  cable.rest_length = taut * length;
  cable.stiffness = tension / (length - cable.rest_length);
  network.structure.cables.push_back(cable);
  return network;
}

}  // namespace tencer::sparsify
