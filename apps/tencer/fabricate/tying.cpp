#include "fabricate/tying.hpp"

#include <algorithm>
#include <tencer/fabricate/tying_order.hpp>
#include <tencer/model/units.hpp>
#include <tencer/rehearsal/tying.hpp>

namespace tencer::app {

std::vector<int> TyingOrder::cables() const {
  std::vector<int> all = held;
  for (const TyingStep& step : steps) all.push_back(step.cable);
  return all;
}

TyingOrder tying_order(const model::Design& design, const fabricate::CutList& list) {
  const std::vector<int> along = fabricate::tying_order(list);
  const auto found = rehearsal::tying(design);
  if (!found) return {.held = along};
  TyingOrder order{.rehearsed = true};
  for (const int cable : along) {
    const auto held = std::ranges::find(found->held, cable, &motion::Held::cable);
    if (held == found->held.end()) continue;
    order.held.push_back(cable);
    if (held->obstacle == motion::Obstacle::falls) order.would_fall.push_back(cable);
  }
  const double mm = 1e3 * model::metres(design.length_unit);
  for (const rehearsal::TyingStep& step : found->steps)
    order.steps.push_back({.cable = step.cable,
                           .moved_mm = mm * step.moved,
                           .tension_n = model::newtons(design.force_unit) * step.tension,
                           .parts = step.parts});
  return order;
}

}  // namespace tencer::app
