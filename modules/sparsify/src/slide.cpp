#include <algorithm>
#include <tencer/core/error.hpp>
#include <tencer/sparsify/slide.hpp>

#include "refine.hpp"
#include "stage_clock.hpp"

namespace tencer::sparsify {

StageResult slide(const Network& network, const sensitivity::Target& target, const Rules& rules,
                  const optimize::Backend& backend, const OuterOptions& outer,
                  const Control& control) {
  validate(rules, network.structure);
  StageClock clock("slide", control);
  if (auto refusal = refused(network, target, clock)) return std::move(*refusal);
  const auto before = sensitivity::deviation(target, network.state);
  // The objective is of order one at the start.
  const RefineSetup setup{.percent = std::max(before.rms_percent, 1e-6),
                          .slide = true,
                          .least_eigenvalue = least_eigenvalue(network, outer),
                          .rules = rules};
  Effort effort;
  Refined refined = refine(network, target, setup, backend, outer, control, effort);
  clock.count(effort);
  StageResult result{.network = std::move(refined.network)};
  result.trace.push_back(clock.row(result.network, target, refined.note));
  finish(result, target, clock);
  return result;
}

}  // namespace tencer::sparsify
