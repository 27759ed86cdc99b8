#include <tencer/core/error.hpp>
#include <tencer/sparsify/thin.hpp>

#include "thinning.hpp"

namespace tencer::sparsify {

void validate(const ThinOptions& options) {
  core::require(options.max_percent > 0, "ThinOptions::max_percent must be positive");
  core::require(options.cables >= 0, "ThinOptions::cables must not be negative");
}

ThinResult thin(const Network& network, const sensitivity::Target& target, const Rules& rules,
                std::span<const springs::Cable> candidates, const symmetry::Group* symmetry,
                const ThinOptions& options, const Control& control) {
  validate(options);
  validate(rules, network.structure);
  StageClock clock("thin", control);
  if (auto refusal = refused(network, target, clock)) return {.stage = std::move(*refusal)};
  const Task task = task_for(network, target, rules, symmetry, options);
  Thinning thinning(task, candidates, options, control, clock);
  StageResult result{.network = network};
  const Start start{.network = network};
  Pool pool = thinning.descend_from({&start, 1});
  const auto record = [&] {
    if (const Choice* best = pool.answer(options)) result.network = best->network;
    clock.count(thinning.take_effort());
    result.trace.push_back(clock.row(result.network, target));
  };
  record();
  thinning.improve({&pool, 1}, 2, record);
  finish(result, target, clock);
  return {.stage = std::move(result), .choices = pool.best()};
}

}  // namespace tencer::sparsify
