#include "multistart/pareto_archive.hpp"

#include <iterator>
#include <utility>

namespace tencer::elimination {
namespace {

using ByCables = std::map<int, Solution>;

void keep_closest(Solution solution, ByCables& closest) {
  const auto [at, added] = closest.try_emplace(solution.cables(), solution);
  if (!added && solution.max_percent < at->second.max_percent) at->second = std::move(solution);
}

const Solution* pick(const ByCables& closest, const model::Goal& goal) {
  std::vector<model::Score> scores;
  for (const auto& [cables, solution] : closest) scores.push_back(solution.score());
  const int at = goal.pick(scores);
  return at < 0 ? nullptr : &std::next(closest.begin(), at)->second;
}

}  // namespace

void ParetoArchive::add(Solution solution) {
  if (solution.settles) keep_closest(solution, settling_);
  keep_closest(std::move(solution), closest_);
}

void ParetoArchive::add(const ParetoArchive& other) {
  for (const auto& [cables, solution] : other.settling_) keep_closest(solution, settling_);
  for (const auto& [cables, solution] : other.closest_) keep_closest(solution, closest_);
}

const Solution* ParetoArchive::best_for(const model::Goal& goal) const {
  const Solution* closest = pick(closest_, goal);
  const Solution* settling = pick(settling_, goal);
  return settling && goal.prefers_settling(settling->score(), closest->score()) ? settling
                                                                                : closest;
}

std::vector<Solution> ParetoArchive::best() const {
  std::vector<Solution> result;
  for (const auto& [cables, closest] : closest_) {
    const auto settling = settling_.find(cables);
    const Solution& solution = settling == settling_.end() ? closest : settling->second;
    if (result.empty() || solution.max_percent < result.back().max_percent)
      result.push_back(solution);
  }
  return result;
}

}  // namespace tencer::elimination
