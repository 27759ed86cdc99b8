#include "moves/insertion.hpp"

#include <algorithm>
#include <cmath>
#include <tencer/ground_structure/candidate_columns.hpp>
#include <tencer/network/rest_length.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <tencer/springs/law.hpp>
#include <utility>

namespace tencer::elimination {
namespace {

using ground_structure::CandidateColumn;
using ground_structure::CandidateOrbit;

struct Rated {
  int candidate = 0;
  double rate = 0.0;
};

// Whether two ends are within a part of the rod's length of each other.
bool near(const springs::End& a, const springs::End& b, const equilibrium::System& system,
          double part) {
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

bool alike(const CandidateOrbit& orbit, const springs::Cable& other,
           const equilibrium::System& system, double part) {
  return std::ranges::any_of(orbit, [&](const CandidateColumn& column) {
    const springs::Cable& cable = column.cable;
    return (near(cable.a, other.a, system, part) && near(cable.b, other.b, system, part)) ||
           (near(cable.a, other.b, system, part) && near(cable.b, other.a, system, part));
  });
}

// The candidates by how fast the distance falls in their tension, the fastest first; no two alike.
std::vector<Rated> steepest(const equilibrium::System& system,
                            const std::vector<CandidateOrbit>& orbits,
                            const Eigen::VectorXd& adjoint, double max_cable_length,
                            const LocalSearchOptions& options) {
  std::vector<Rated> rated;
  for (int c = 0; c < static_cast<int>(orbits.size()); ++c) {
    double slope = 0;
    bool short_enough = true;
    for (const CandidateColumn& column : orbits[c]) {
      for_each_unknown(system, column, [&](int i, double weight) { slope += weight * adjoint[i]; });
      short_enough = short_enough && column.length <= max_cable_length;
    }
    if (slope < 0 && short_enough) rated.push_back({c, slope});
  }
  std::ranges::sort(rated, {}, [](const Rated& r) { return std::pair(r.rate, r.candidate); });
  std::vector<Rated> different;
  for (const Rated& next : rated) {
    if (static_cast<int>(different.size()) == options.candidates) break;
    const springs::Cable& cable = orbits[next.candidate].front().cable;
    if (std::ranges::none_of(different, [&](const Rated& known) {
          return alike(orbits[known.candidate], cable, system, options.alike);
        }))
      different.push_back(next);
  }
  return different;
}

}  // namespace

std::vector<Insertion> best_insertions(const FittedNetwork& fitted,
                                       std::span<const springs::Cable> candidates, int max_count,
                                       const LocalSearchOptions& options) {
  const auto& at = fitted.at();
  const auto& system = at.system;
  const Requirements& requirements = fitted.requirements();
  const sensitivity::Distance distance(requirements.target, system, at.state);
  const auto orbits =
      ground_structure::candidate_orbits(system, at.state, candidates, requirements.symmetry);
  auto rated = steepest(system, orbits, sensitivity::adjoint(at, distance),
                        requirements.rules.max_cable_length, options);

  const GaussNewtonModel model = fitted.gauss_newton_model();
  Eigen::MatrixXd forces =
      Eigen::MatrixXd::Zero(system.size(), static_cast<Eigen::Index>(rated.size()));
  for (Eigen::Index k = 0; k < forces.cols(); ++k) {
    for (const CandidateColumn& column : orbits[rated[k].candidate])
      for_each_unknown(system, column, [&](int i, double weight) { forces(i, k) -= weight; });
    equilibrium::remove_rigid(at.linearisation.rigid, forces.col(k));
  }
  const Eigen::MatrixXd rates = distance.residual_rates(at.linearisation.solve(forces));
  std::vector<double> tensions(orbits.size(), 0.0);
  for (Eigen::Index k = 0; k < rates.cols(); ++k) {
    const auto gain = model.gain(rates.col(k));
    tensions[rated[k].candidate] = gain.at;
    rated[k].rate = gain.value;
  }
  std::ranges::sort(rated, {}, [](const Rated& r) { return std::pair(-r.rate, r.candidate); });
  std::vector<Insertion> insertions;
  for (const Rated& next : rated) {
    if (!(next.rate > 0) || static_cast<int>(insertions.size()) == max_count) break;
    Insertion& insertion = insertions.emplace_back();
    insertion.tension = tensions[next.candidate];
    for (const CandidateColumn& column : orbits[next.candidate])
      insertion.cables.push_back(column.cable);
  }
  return insertions;
}

network::Network with_insertion(network::Network network, const Insertion& insertion, double part) {
  const auto along = model::arc_lengths(network.structure);
  for (const springs::Cable& cable : insertion.cables) {
    const auto stencil = springs::stencil(cable, along, network.structure.anchors);
    const double length = model::span_of(stencil, network.state).norm();
    network.structure.cables.push_back(
        springs::with_tension(cable, length, part * insertion.tension, network::stiff_rest_ratio));
  }
  return network;
}

}  // namespace tencer::elimination
