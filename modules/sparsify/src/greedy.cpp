#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <tencer/sparsify/greedy.hpp>

#include "spring_set.hpp"

namespace tencer::sparsify {
namespace {

bool usable(equilibrium::Reason reason) {
  return equilibrium::Equilibrium{.reason = reason}.usable();
}

// On the way the equilibria need only be as accurate as the comparison of tensions.
network::Control rough(network::Control control) {
  control.solve.tolerance = std::max(control.solve.tolerance, 1e-6);
  return control;
}

// Solves, takes out what is in compression (the hardest part of it), and so on until nothing is.
equilibrium::Reason prune_compressed(SpringSet& set, double hardest_part = 0.0) {
  for (;;) {
    const auto reason = set.solve();
    if (!usable(reason)) return reason;
    const Eigen::VectorXd tensions = set.tensions();
    if (tensions.size() == 0) return reason;
    const double most = std::min(0.0, hardest_part * tensions.minCoeff());
    std::vector<int> pushing;
    for (Eigen::Index i = 0; i < tensions.size(); ++i)
      if (tensions[i] <= most) pushing.push_back(static_cast<int>(i));
    if (pushing.empty()) return reason;
    set.take_out(pushing);
  }
}

network::StageResult result_of(SpringSet& set, const model::Target& target,
                               network::StageRecorder& recorder, double tolerance) {
  set.finish_with(tolerance);
  const auto reason = prune_compressed(set);
  network::StageResult result{.network = set.network()};
  recorder.add(set.counts());
  result.trace.push_back(
      recorder.row(result.network, target, usable(reason) ? "" : equilibrium::describe(reason)));
  recorder.finish(result, target);
  return result;
}

int weakest(const Eigen::VectorXd& tensions) {
  Eigen::Index result = 0;
  tensions.minCoeff(&result);
  return static_cast<int>(result);
}

}  // namespace

void PruneOptions::validate() const {
  core::require(hardest_part >= 0 && hardest_part <= 1,
                "PruneOptions::hardest_part must be between 0 and 1");
}

network::StageResult prune(const network::Network& network, const model::Target& target,
                           const PruneOptions& options, const network::Control& control) {
  options.validate();
  network::StageRecorder recorder("prune", control);
  recorder.report(static_cast<int>(network.structure.cables.size()), 0);
  SpringSet set(network, rough(control));
  prune_compressed(set, options.hardest_part);
  if (options.all_or_nothing && recorder.stopped())
    return {.network = network,
            .trace = {recorder.row(set.network(), target, "interrupted")},
            .interrupted = true};
  return result_of(set, target, recorder, control.solve.tolerance);
}

void GreedyOptions::validate() const {
  core::require(threshold > 0, "GreedyOptions::threshold must be positive");
  core::require(min_springs > 0, "GreedyOptions::min_springs must be positive");
}

network::StageResult remove_greedily(const network::Network& network, const model::Target& target,
                                     const GreedyOptions& options,
                                     const network::Control& control) {
  options.validate();
  network::StageRecorder recorder("greedy", control);
  int vertices = 0;
  for (const auto& rod : network.structure.rods) vertices += rod.vertices();
  const double limit = options.threshold * vertices * model::total_length(network.structure);

  SpringSet set(network, rough(control));
  while (set.count() > options.min_springs && !recorder.stopped()) {
    set.take_out({weakest(set.tensions())});
    const auto reason = prune_compressed(set);
    const auto deviation = sensitivity::deviation(target, set.state());
    if (!usable(reason) || set.count() == 0 || std::sqrt(deviation.value) > limit) break;
    set.commit();
    recorder.report(set.count(), deviation.max_percent);
  }
  set.revert();
  return result_of(set, target, recorder, control.solve.tolerance);
}

}  // namespace tencer::sparsify
