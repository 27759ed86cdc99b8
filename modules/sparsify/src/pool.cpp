#include "pool.hpp"

#include <utility>

namespace tencer::sparsify {

int cables_of(const Choice& choice) {
  return static_cast<int>(choice.network.structure.cables.size());
}

void Pool::add(Choice choice) {
  const int cables = cables_of(choice);
  const auto [at, added] = closest_.try_emplace(cables, choice);
  if (!added && choice.max_percent < at->second.max_percent) at->second = std::move(choice);
}

void Pool::add(Pool other) {
  for (auto& [cables, choice] : other.closest_) add(std::move(choice));
}

const Choice* Pool::answer(const ThinOptions& options) const {
  const Choice* best = nullptr;
  for (const auto& [cables, choice] : closest_) {
    if (options.cables == 0 && choice.max_percent <= options.max_percent) return &choice;
    if (options.cables > 0 && cables > options.cables && best) break;
    if (!best || choice.max_percent < best->max_percent) best = &choice;
  }
  return best;
}

std::vector<Choice> Pool::best() const {
  std::vector<Choice> result;
  for (const auto& [cables, choice] : closest_)
    if (result.empty() || choice.max_percent < result.back().max_percent) result.push_back(choice);
  return result;
}

bool better(const Choice& next, const Choice& choice, const ThinOptions& options) {
  constexpr double clearly = 0.97;
  if (options.cables == 0) {
    const bool close = next.max_percent <= options.max_percent;
    if (close && choice.max_percent <= options.max_percent && cables_of(next) != cables_of(choice))
      return cables_of(next) < cables_of(choice);
  }
  return next.max_percent < clearly * choice.max_percent;
}

}  // namespace tencer::sparsify
