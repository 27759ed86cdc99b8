#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/sparsify/decimate.hpp>

#include "spring_set.hpp"
#include "stage_clock.hpp"

namespace tencer::sparsify {
namespace {

bool usable(equilibrium::Reason reason) {
  return equilibrium::Equilibrium{.reason = reason}.usable();
}

// On the way the equilibria need only be as accurate as the comparison of tensions.
Control rough(Control control) {
  control.solve.tolerance = std::max(control.solve.tolerance, 1e-6);
  return control;
}

// Solves, takes out what is in compression, and so on until nothing is.
equilibrium::Reason settle(SpringSet& set) {
  for (;;) {
    const auto reason = set.solve();
    if (!usable(reason)) return reason;
    const Eigen::VectorXd tensions = set.tensions();
    std::vector<int> pushing;
    for (Eigen::Index i = 0; i < tensions.size(); ++i)
      if (tensions[i] <= 0) pushing.push_back(static_cast<int>(i));
    if (pushing.empty()) return reason;
    set.take_out(pushing);
  }
}

StageResult result_of(SpringSet& set, const sensitivity::Target& target, StageClock& clock,
                      double tolerance) {
  set.finish_with(tolerance);
  const auto reason = settle(set);
  StageResult result{.network = set.network()};
  clock.count({.solves = set.solves(), .iterations = set.iterations()});
  result.trace.push_back(
      clock.row(result.network, target, usable(reason) ? "" : equilibrium::describe(reason)));
  finish(result, target, clock);
  return result;
}

int weakest(const Eigen::VectorXd& tensions) {
  Eigen::Index result = 0;
  tensions.minCoeff(&result);
  return static_cast<int>(result);
}

}  // namespace

StageResult prune(const Network& network, const sensitivity::Target& target,
                  const Control& control) {
  StageClock clock("prune", control);
  clock.report(static_cast<int>(network.structure.cables.size()), 0);
  SpringSet set(network, rough(control));
  settle(set);
  return result_of(set, target, clock, control.solve.tolerance);
}

StageResult decimate(const Network& network, const sensitivity::Target& target,
                     const DecimateOptions& options, const Control& control) {
  core::require(options.threshold > 0, "DecimateOptions::threshold must be positive");
  StageClock clock("greedy", control);
  double length = 0;
  int vertices = 0;
  for (const auto& rod : network.structure.rods) {
    length += rod.length();
    vertices += rod.vertices();
  }
  const double limit = options.threshold * vertices * length;

  SpringSet set(network, rough(control));
  while (set.count() > 1 && !clock.stopped()) {
    set.take_out({weakest(set.tensions())});
    const auto reason = settle(set);
    const auto deviation = sensitivity::deviation(target, set.state());
    if (!usable(reason) || set.count() == 0 || std::sqrt(deviation.value) > limit) break;
    set.commit();
    clock.report(set.count(), deviation.max_percent);
  }
  set.revert();
  return result_of(set, target, clock, control.solve.tolerance);
}

}  // namespace tencer::sparsify
