#include <algorithm>
#include <limits>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/stability.hpp>
#include <tencer/network/rest_length.hpp>
#include <tencer/springs/law.hpp>

namespace tencer::network {
namespace {

double eigenvalue_at(const Network& network, double rest_ratio) {
  const Network trial = rebased(network, rest_ratio);
  const auto stability = equilibrium::stability(equilibrium::System(trial.structure), trial.state);
  if (!stability.computed || stability.floating_components > 0)
    return -std::numeric_limits<double>::infinity();
  return stability.smallest_eigenvalue;
}

// The rest ratio 0.99, or the first beyond with which the network is stable; the last when it is
// with none.
RestLength stiffest(const Network& network) {
  RestLength result;
  for (const double rest_ratio : {0.99, 0.999, 0.9999, 0.99999}) {
    result = {.rest_ratio = rest_ratio, .smallest_eigenvalue = eigenvalue_at(network, rest_ratio)};
    result.stable = result.smallest_eigenvalue > 0;
    if (result.stable) break;
  }
  return result;
}

}  // namespace

Network rebased(Network network, double rest_ratio) {
  const Eigen::VectorXd lengths = cable_lengths(network);
  for (Eigen::Index i = 0; i < lengths.size(); ++i) {
    auto& cable = network.structure.cables[i];
    core::require(springs::tension(cable, lengths[i]) > 0, "rebased: every cable must pull");
    cable = springs::rebased(cable, lengths[i], rest_ratio);
  }
  return network;
}

double stiffest_eigenvalue(const Network& network) { return stiffest(network).smallest_eigenvalue; }

void RestLengthOptions::validate() const {
  core::require(margin >= 0 && margin < 1, "RestLengthOptions::margin must be in [0, 1)");
}

RestLength smallest_stable_rest_length(const Network& network, const RestLengthOptions& options) {
  options.validate();
  const RestLength limit = stiffest(network);
  if (!limit.stable || limit.rest_ratio > 0.99) return limit;
  const double wanted = std::max(options.margin * limit.smallest_eigenvalue,
                                 std::min(options.min_eigenvalue, 0.9 * limit.smallest_eigenvalue));
  const auto ratio = [](int percent) { return percent / 100.0; };
  const auto stable = [&](double eigenvalue) { return eigenvalue > 0 && eigenvalue >= wanted; };

  const double softest = eigenvalue_at(network, 0.0);
  if (stable(softest)) return {.rest_ratio = 0.0, .smallest_eigenvalue = softest, .stable = true};
  int unstable_percent = 0;
  int stable_percent = 99;
  double eigenvalue = limit.smallest_eigenvalue;
  while (stable_percent - unstable_percent > 1) {
    const int middle = (stable_percent + unstable_percent) / 2;
    const double there = eigenvalue_at(network, ratio(middle));
    if (stable(there)) {
      stable_percent = middle;
      eigenvalue = there;
    } else {
      unstable_percent = middle;
    }
  }
  return {.rest_ratio = ratio(stable_percent), .smallest_eigenvalue = eigenvalue, .stable = true};
}

}  // namespace tencer::network
