#include <tencer/rehearsal/tying.hpp>
#include <utility>

#include "resting.hpp"

namespace tencer::rehearsal {

std::optional<Tying> tying(const model::Design& design, const std::stop_token& stop) {
  const std::optional<Resting> finished = resting(design, stop);
  if (!finished) return std::nullopt;
  motion::TyingPlan plan =
      motion::tying_plan(finished->structure, finished->state, finished->tensions, stop);
  const core::Scale& scale = finished->scaling.scale;
  Tying result{.held = std::move(plan.held), .finished = plan.finished};
  for (const motion::Tied& tied : plan.steps)
    result.steps.push_back({.cable = tied.cable,
                            .moved = tied.moved * scale.length,
                            .tension = tied.tension * scale.force(),
                            .parts = tied.parts,
                            .before = fitted(*finished, tied.before, finished->design.pose).pose});
  return result;
}

}  // namespace tencer::rehearsal
