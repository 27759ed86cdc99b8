#include <tencer/core/error.hpp>
#include <tencer/model/goal.hpp>

namespace tencer::model {

bool Goal::improves(const Score& next, const Score& best) const {
  constexpr double clearly = 0.97;
  if (next.footing != best.footing) return next.footing > best.footing && met(next);
  if (!by_number() && met(next) && met(best) && next.cables != best.cables)
    return next.cables < best.cables;
  return next.max_percent < clearly * best.max_percent;
}

int Goal::pick(std::span<const Score> scores) const {
  int best = -1;
  for (int i = 0; i < static_cast<int>(scores.size()); ++i) {
    if (!by_number() && met(scores[i])) return i;
    if (by_number() && !met(scores[i]) && best >= 0) break;
    if (best < 0 || scores[i].max_percent < scores[best].max_percent) best = i;
  }
  return best;
}

bool Goal::prefers_footing(const Score& firmer, const Score& other) const {
  constexpr double worth = 2;  // times the distance
  return met(firmer) && (!by_number() || firmer.max_percent <= worth * other.max_percent);
}

void Goal::validate() const {
  core::require(max_error_percent > 0, "Goal::max_error_percent must be positive");
  core::require(cables >= 0, "Goal::cables must not be negative");
}

}  // namespace tencer::model
