#include <algorithm>
#include <tencer/core/error.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <tencer/sparsify/slide.hpp>

#include "rounds.hpp"

namespace tencer::sparsify {

network::StageResult slide(const network::Network& network, const model::Target& target,
                           const model::Rules& rules, const optimize::Backend& backend,
                           const OuterOptions& outer, const network::Control& control) {
  validate(rules, network.structure);
  outer.validate();
  network::StageRecorder recorder("slide", control);
  if (auto refusal = recorder.refusal(network, target)) return std::move(*refusal);
  const auto before = sensitivity::deviation(target, network.state);
  // The objective is of order one at the start.
  const RoundsSetup setup{.unit_percent = std::max(before.rms_percent, 1e-6),
                          .slide = true,
                          .min_eigenvalue = min_eigenvalue(network, outer),
                          .rules = rules};
  network::SolveCounts counts;
  Improved improved = improve_in_rounds(network, target, setup, backend, outer, control, counts);
  recorder.add(counts);
  network::StageResult result{.network = std::move(improved.network)};
  result.trace.push_back(recorder.row(result.network, target, improved.note));
  recorder.finish(result, target);
  return result;
}

}  // namespace tencer::sparsify
