#include "moves/insertion.hpp"

#include <algorithm>
#include <cmath>
#include <tencer/ground_structure/candidate_columns.hpp>
#include <tencer/network/rest_length.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <tencer/springs/alike.hpp>
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

bool alike(const CandidateOrbit& orbit, const springs::Cable& other,
           const equilibrium::System& system, double part) {
  return std::ranges::any_of(orbit, [&](const CandidateColumn& column) {
    return springs::alike(column.cable, other, system.arc_lengths(), part);
  });
}

bool short_enough(const CandidateOrbit& orbit, const model::Rules& rules) {
  return std::ranges::all_of(orbit, [&](const CandidateColumn& column) {
    return column.length <= rules.max_cable_length;
  });
}

// Those of the least rate, at most so many, the least first; no two alike.
std::vector<Rated> least_different(std::vector<Rated> rated,
                                   const std::vector<CandidateOrbit>& orbits,
                                   const equilibrium::System& system, int max_count, double part) {
  std::ranges::sort(rated, {}, [](const Rated& r) { return std::pair(r.rate, r.candidate); });
  std::vector<Rated> different;
  for (const Rated& next : rated) {
    if (static_cast<int>(different.size()) == max_count) break;
    const springs::Cable& cable = orbits[next.candidate].front().cable;
    if (std::ranges::none_of(different, [&](const Rated& known) {
          return alike(orbits[known.candidate], cable, system, part);
        }))
      different.push_back(next);
  }
  return different;
}

// The candidates by how fast the distance falls in their tension.
std::vector<Rated> by_slope(const equilibrium::System& system,
                            const std::vector<CandidateOrbit>& orbits,
                            const Eigen::VectorXd& adjoint, const model::Rules& rules) {
  std::vector<Rated> rated;
  for (int c = 0; c < static_cast<int>(orbits.size()); ++c) {
    double slope = 0;
    for (const CandidateColumn& column : orbits[c])
      for_each_unknown(system, column, [&](int i, double weight) { slope += weight * adjoint[i]; });
    if (slope < 0 && short_enough(orbits[c], rules)) rated.push_back({c, slope});
  }
  return rated;
}

// The trace of `covariance`, of the soft modes' coordinates, once the orbit's cables keep their
// lengths but for changes of the variance own(column): each is one more measurement of the
// coordinates. The same holds for the compliance, where own is that of the cable.
template <class Own>
double left_by(const equilibrium::System& system, const CandidateOrbit& orbit,
               const Eigen::MatrixXd& modes, Eigen::MatrixXd covariance, const Own& own) {
  for (const CandidateColumn& column : orbit) {
    Eigen::VectorXd stretch = Eigen::VectorXd::Zero(modes.cols());
    for_each_unknown(system, column,
                     [&](int i, double weight) { stretch += weight * modes.row(i).transpose(); });
    const Eigen::VectorXd gain = covariance * stretch;
    covariance -= gain * gain.transpose() / (stretch.dot(gain) + own(column));
  }
  return covariance.trace();
}

Insertion insertion_of(const CandidateOrbit& orbit, double tension) {
  Insertion insertion{.tension = tension};
  for (const CandidateColumn& column : orbit) insertion.cables.push_back(column.cable);
  return insertion;
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
  auto rated = least_different(
      by_slope(system, orbits, sensitivity::adjoint(at, distance), requirements.rules), orbits,
      system, options.candidates, options.alike);

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
    insertions.push_back(insertion_of(orbits[next.candidate], tensions[next.candidate]));
  }
  return insertions;
}

std::vector<Insertion> best_braces(const FittedNetwork& fitted,
                                   std::span<const springs::Cable> candidates, int max_count,
                                   const LocalSearchOptions& options) {
  const auto& at = fitted.at();
  const auto& system = at.system;
  const Requirements& requirements = fitted.requirements();
  const auto orbits =
      ground_structure::candidate_orbits(system, at.state, candidates, requirements.symmetry);
  const equilibrium::SoftModes& soft = fitted.soft();
  const Workmanship& workmanship = requirements.workmanship;
  const Eigen::VectorXd tensions = cable_tensions(fitted.network());
  const double tension = std::max(options.brace_tension * tensions.mean(),
                                  2 * workmanship.least_tension(tensions.maxCoeff()));
  const bool by_errors = fitted.errors().covariance.trace() > 0;
  // Errors of both attachments count by the cosines of their angles, whose squares are half in the
  // mean.
  const double variance =
      (std::pow(workmanship.length_error, 2) + std::pow(workmanship.attachment_error, 2)) / 3;
  const auto own = [&](const CandidateColumn& column) {
    return by_errors ? variance : (1 - network::stiff_rest_ratio) * column.length / tension;
  };
  Eigen::MatrixXd covariance = fitted.errors().covariance;
  if (!by_errors)
    covariance = (soft.values * equilibrium::eigenvalue_unit(system.structure()))
                     .cwiseInverse()
                     .asDiagonal();
  std::vector<Rated> rated;
  for (int c = 0; c < static_cast<int>(orbits.size()); ++c)
    if (short_enough(orbits[c], requirements.rules))
      rated.push_back({c, left_by(system, orbits[c], soft.modes, covariance, own)});
  rated = least_different(std::move(rated), orbits, system, max_count, options.alike);
  std::vector<Insertion> braces;
  for (const Rated& next : rated) braces.push_back(insertion_of(orbits[next.candidate], tension));
  return braces;
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
