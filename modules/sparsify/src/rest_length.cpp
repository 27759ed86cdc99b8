#include <algorithm>
#include <limits>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/stability.hpp>
#include <tencer/sparsify/rest_length.hpp>
#include <tencer/springs/law.hpp>

namespace tencer::sparsify {
namespace {

double eigenvalue_at(const Network& network, double rho) {
  const Network trial = rebased(network, rho);
  const auto stability = equilibrium::stability(equilibrium::System(trial.structure), trial.state);
  if (!stability.computed || stability.loose_groups > 0)
    return -std::numeric_limits<double>::infinity();
  return stability.smallest_eigenvalue;
}

}  // namespace

Network rebased(Network network, double rho) {
  const Eigen::VectorXd lengths = cable_lengths(network);
  for (Eigen::Index i = 0; i < lengths.size(); ++i) {
    auto& cable = network.structure.cables[i];
    core::require(springs::tension(cable, lengths[i]) > 0, "rebased: every cable must pull");
    cable = springs::rebased(cable, lengths[i], rho);
  }
  return network;
}

double stiffest_eigenvalue(const Network& network) { return eigenvalue_at(network, 0.99); }

RestLength smallest_stable_rest_length(const Network& network, const RestLengthOptions& options) {
  core::require(options.margin >= 0 && options.margin < 1,
                "RestLengthOptions::margin must be in [0, 1)");
  const auto rho = [](int percent) { return percent / 100.0; };
  const double stiffest = stiffest_eigenvalue(network);
  if (!(stiffest > 0)) return {.rho = rho(99), .smallest_eigenvalue = stiffest, .stable = false};
  const double wanted =
      std::max(options.margin * stiffest, std::min(options.least, 0.9 * stiffest));
  const auto stable = [&](double eigenvalue) { return eigenvalue > 0 && eigenvalue >= wanted; };

  const double softest = eigenvalue_at(network, 0.0);
  if (stable(softest)) return {.rho = 0.0, .smallest_eigenvalue = softest, .stable = true};
  int unstable_percent = 0;
  int stable_percent = 99;
  double eigenvalue = stiffest;
  while (stable_percent - unstable_percent > 1) {
    const int middle = (stable_percent + unstable_percent) / 2;
    const double there = eigenvalue_at(network, rho(middle));
    if (stable(there)) {
      stable_percent = middle;
      eigenvalue = there;
    } else {
      unstable_percent = middle;
    }
  }
  return {.rho = rho(stable_percent), .smallest_eigenvalue = eigenvalue, .stable = true};
}

}  // namespace tencer::sparsify
