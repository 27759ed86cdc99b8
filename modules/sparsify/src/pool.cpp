#include "pool.hpp"

#include <utility>

namespace tencer::sparsify {

int cables_of(const Choice& choice) {
  return static_cast<int>(choice.network.structure.cables.size());
}

namespace {

void keep_closest(Choice choice, std::map<int, Choice>& closest) {
  const auto [at, added] = closest.try_emplace(cables_of(choice), choice);
  if (!added && choice.max_percent < at->second.max_percent) at->second = std::move(choice);
}

const Choice* best_of(const std::map<int, Choice>& closest, const ThinOptions& options) {
  const Choice* best = nullptr;
  for (const auto& [cables, choice] : closest) {
    if (options.cables == 0 && choice.max_percent <= options.max_percent) return &choice;
    if (options.cables > 0 && cables > options.cables && best) break;
    if (!best || choice.max_percent < best->max_percent) best = &choice;
  }
  return best;
}

bool answers(const Choice& choice, const ThinOptions& options) {
  return options.cables > 0 ? cables_of(choice) <= options.cables
                            : choice.max_percent <= options.max_percent;
}

}  // namespace

void Pool::add(Choice choice) {
  if (choice.settles) keep_closest(choice, settling_);
  keep_closest(std::move(choice), closest_);
}

void Pool::add(const Pool& other) {
  for (const auto& [cables, choice] : other.settling_) keep_closest(choice, settling_);
  for (const auto& [cables, choice] : other.closest_) keep_closest(choice, closest_);
}

const Choice* Pool::answer(const ThinOptions& options) const {
  constexpr double worth = 2;  // times the distance, with a number of cables asked for
  const Choice* closest = best_of(closest_, options);
  const Choice* settling = best_of(settling_, options);
  const bool preferred =
      settling && answers(*settling, options) &&
      (options.cables == 0 || settling->max_percent <= worth * closest->max_percent);
  return preferred ? settling : closest;
}

std::vector<Choice> Pool::best() const {
  std::vector<Choice> result;
  for (const auto& [cables, closest] : closest_) {
    const auto settling = settling_.find(cables);
    const Choice& choice = settling == settling_.end() ? closest : settling->second;
    if (result.empty() || choice.max_percent < result.back().max_percent) result.push_back(choice);
  }
  return result;
}

bool better(const Choice& next, const Choice& choice, const ThinOptions& options) {
  constexpr double clearly = 0.97;
  if (next.settles != choice.settles) return next.settles && answers(next, options);
  if (options.cables == 0) {
    const bool close = next.max_percent <= options.max_percent;
    if (close && choice.max_percent <= options.max_percent && cables_of(next) != cables_of(choice))
      return cables_of(next) < cables_of(choice);
  }
  return next.max_percent < clearly * choice.max_percent;
}

}  // namespace tencer::sparsify
