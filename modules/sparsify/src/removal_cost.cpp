#include "removal_cost.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "refit.hpp"

namespace tencer::sparsify {
namespace {

constexpr int refit_steps = 40;  // of a cable that is taken out gradually

bool usable(const sensitivity::Trial& trial, const sensitivity::Tracker& tracker, Effort& effort) {
  effort.solves += trial.solves;
  effort.iterations += trial.equilibrium.iterations;
  return trial.usable() && tracker.trial().linearisation.regular;
}

}  // namespace

std::vector<Removal> removals(const Network& network, const sensitivity::Target& target,
                              const RefineSetup& setup, const Control& control, Effort& effort) {
  std::vector<Removal> result;
  sensitivity::Tracker tracker(network.structure, network.state, follow_options(control));
  if (!tracker.first().usable() || !tracker.committed().linearisation.regular) return result;
  const Refitter refitter(network, target, setup);
  const Eigen::VectorXd tensions = cable_tensions(network);
  for (int i = 0; i < static_cast<int>(tensions.size()) && !control.stop.stop_requested(); ++i) {
    Removal removal{.cable = i,
                    .cost = std::numeric_limits<double>::infinity(),
                    .refitted = network.structure.cables};
    removal.refitted[i].stiffness = 0;
    if (usable(tracker.evaluate(removal.refitted), tracker, effort)) {
      auto refit = refitter.at(tracker.trial(), i);
      removal.cost = refit.distance;
      removal.refitted = std::move(refit.cables);
    }
    result.push_back(std::move(removal));
  }
  std::ranges::sort(result, [&](const Removal& a, const Removal& b) {
    return std::pair(a.cost, tensions[a.cable]) < std::pair(b.cost, tensions[b.cable]);
  });
  return result;
}

std::optional<Network> without_gradually(const Network& network, int cable,
                                         const sensitivity::Target& target,
                                         const RefineSetup& setup, const Control& control,
                                         Effort& effort) {
  constexpr double faint = 0.02;  // share of the stiffness that may be dropped at once
  sensitivity::Tracker tracker(network.structure, network.state, follow_options(control));
  if (!tracker.first().usable() || !tracker.committed().linearisation.regular) return std::nullopt;
  const Refitter refitter(network, target, setup);
  const auto try_and_commit = [&](const std::vector<springs::Cable>& cables) {
    const bool followed = usable(tracker.evaluate(cables), tracker, effort);
    if (followed) tracker.commit();
    return followed;
  };
  const double full = network.structure.cables[cable].stiffness;
  double factor = 0.5;
  for (int step = 0; step < refit_steps && !control.stop.stop_requested(); ++step) {
    auto cables = tracker.committed().cables();
    const double present = cables[cable].stiffness;
    if (present < faint * full) {
      Network there{network.structure, tracker.committed().state};
      there.structure.cables = std::move(cables);
      return without(there, {cable}, control, effort);
    }
    cables[cable].stiffness = factor * present;
    if (!try_and_commit(cables)) {
      factor = (1 + factor) / 2;
      if (factor > 0.95) return std::nullopt;
      continue;
    }
    try_and_commit(refitter.at(tracker.committed(), cable).cables);
    factor = std::max(0.5, 2 * factor - 1);
  }
  return std::nullopt;
}

}  // namespace tencer::sparsify
