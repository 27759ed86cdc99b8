#include "offers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "target_balance.hpp"

namespace tencer::sparsify {
namespace {

constexpr std::size_t looked_at = 40;  // candidates whose gain is worked out in full

struct Rated {
  int candidate = 0;
  double rate = 0.0;
};

// Whether two ends are within a tenth of the rod of each other.
bool near(const springs::End& a, const springs::End& b, const equilibrium::System& system) {
  constexpr double part = 0.1;
  if (a.index() != b.index()) return false;
  if (const auto* anchor = std::get_if<springs::AtAnchor>(&a))
    return anchor->anchor == std::get<springs::AtAnchor>(b).anchor;
  const auto& on_a = std::get<springs::OnRod>(a);
  const auto& on_b = std::get<springs::OnRod>(b);
  if (on_a.rod != on_b.rod) return false;
  const geometry::ArcLength& rod = system.arc_lengths()[on_a.rod];
  double apart = std::abs(rod.wrap(on_a.s) - rod.wrap(on_b.s));
  if (rod.closed()) apart = std::min(apart, rod.length() - apart);
  return apart < part * rod.length();
}

bool alike(const Pulls& orbit, const springs::Cable& other, const equilibrium::System& system) {
  return std::ranges::any_of(orbit, [&](const Pull& pull) {
    const springs::Cable& cable = pull.cable;
    return (near(cable.a, other.a, system) && near(cable.b, other.b, system)) ||
           (near(cable.a, other.b, system) && near(cable.b, other.a, system));
  });
}

// The candidates by how fast the distance falls in their tension, the fastest first; no two alike.
std::vector<Rated> steepest(const equilibrium::System& system, const std::vector<Pulls>& pulls,
                            const Eigen::VectorXd& adjoint, double longest) {
  std::vector<Rated> rated;
  for (int c = 0; c < static_cast<int>(pulls.size()); ++c) {
    double slope = 0;
    bool short_enough = true;
    for (const Pull& pull : pulls[c]) {
      for_each_unknown(system, pull, [&](int i, double weight) { slope += weight * adjoint[i]; });
      short_enough = short_enough && pull.length <= longest;
    }
    if (slope < 0 && short_enough) rated.push_back({c, slope});
  }
  std::ranges::sort(rated, {}, [](const Rated& r) { return std::pair(r.rate, r.candidate); });
  std::vector<Rated> different;
  for (const Rated& next : rated) {
    if (different.size() == looked_at) break;
    const springs::Cable& cable = pulls[next.candidate].front().cable;
    if (std::ranges::none_of(different, [&](const Rated& known) {
          return alike(pulls[known.candidate], cable, system);
        }))
      different.push_back(next);
  }
  return different;
}

}  // namespace

std::vector<Offer> best_offers(const Walker& walker, const Task& task,
                               std::span<const springs::Cable> candidates, int most) {
  const auto& at = walker.at();
  const auto& system = at.system;
  const sensitivity::Distance distance(task.target, system, at.state);
  const auto pulls = pulls_at(system, at.state, candidates, task.symmetry);
  auto rated = steepest(system, pulls, sensitivity::adjoint(at, distance), task.rules.longest);

  const Planner plan = walker.planner();
  Eigen::MatrixXd forces =
      Eigen::MatrixXd::Zero(system.size(), static_cast<Eigen::Index>(rated.size()));
  for (Eigen::Index k = 0; k < forces.cols(); ++k) {
    for (const Pull& pull : pulls[rated[k].candidate])
      for_each_unknown(system, pull, [&](int i, double weight) { forces(i, k) -= weight; });
    equilibrium::remove_rigid(at.linearisation.rigid, forces.col(k));
  }
  const Eigen::MatrixXd rates = distance.residual_rates(at.linearisation.solve(forces));
  std::vector<double> tensions(pulls.size(), 0.0);
  for (Eigen::Index k = 0; k < rates.cols(); ++k) {
    const auto [gain, tension] = plan.gain(rates.col(k));
    tensions[rated[k].candidate] = tension;
    rated[k].rate = gain;
  }
  std::ranges::sort(rated, {}, [](const Rated& r) { return std::pair(-r.rate, r.candidate); });
  std::vector<Offer> offers;
  for (const Rated& next : rated) {
    if (!(next.rate > 0) || static_cast<int>(offers.size()) == most) break;
    offers.push_back({.cables = {}, .tension = tensions[next.candidate]});
    for (const Pull& pull : pulls[next.candidate]) offers.back().cables.push_back(pull.cable);
  }
  return offers;
}

Network with_offer(Network network, const Offer& offer, double part) {
  std::vector<geometry::ArcLength> along;
  for (const auto& rod : network.structure.rods) along.emplace_back(rod.rest_lengths, rod.closed);
  for (springs::Cable cable : offer.cables) {
    const auto stencil = springs::stencil(cable, along, network.structure.anchors);
    const double length = equilibrium::span_of(stencil, network.state).norm();
    cable.rest_length = taut * length;
    cable.stiffness = part * offer.tension / (length - cable.rest_length);
    network.structure.cables.push_back(cable);
  }
  return network;
}

}  // namespace tencer::sparsify
