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

// Rest lengths of 99 %, or the next of these with which the network is stable, the last when it is
// with none.
RestLength stiffest(const Network& network) {
  RestLength result;
  for (const double rho : {0.99, 0.999, 0.9999, 0.99999}) {
    result = {.rho = rho, .smallest_eigenvalue = eigenvalue_at(network, rho)};
    result.stable = result.smallest_eigenvalue > 0;
    if (result.stable) break;
  }
  return result;
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

double stiffest_eigenvalue(const Network& network) { return stiffest(network).smallest_eigenvalue; }

RestLength smallest_stable_rest_length(const Network& network, const RestLengthOptions& options) {
  core::require(options.margin >= 0 && options.margin < 1,
                "RestLengthOptions::margin must be in [0, 1)");
  const RestLength limit = stiffest(network);
  if (!limit.stable || limit.rho > 0.99) return limit;
  const double wanted = std::max(options.margin * limit.smallest_eigenvalue,
                                 std::min(options.least, 0.9 * limit.smallest_eigenvalue));
  const auto rho = [](int percent) { return percent / 100.0; };
  const auto stable = [&](double eigenvalue) { return eigenvalue > 0 && eigenvalue >= wanted; };

  const double softest = eigenvalue_at(network, 0.0);
  if (stable(softest)) return {.rho = 0.0, .smallest_eigenvalue = softest, .stable = true};
  int unstable_percent = 0;
  int stable_percent = 99;
  double eigenvalue = limit.smallest_eigenvalue;
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
