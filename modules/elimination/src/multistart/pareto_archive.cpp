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
  if (solution.standing.holds()) keep_closest(solution, standing_);
  keep_closest(std::move(solution), closest_);
}

void ParetoArchive::add(const ParetoArchive& other) {
  for (const auto& [cables, solution] : other.standing_) keep_closest(solution, standing_);
  for (const auto& [cables, solution] : other.closest_) keep_closest(solution, closest_);
}

const Solution* ParetoArchive::best_for(const model::Goal& goal) const {
  const Solution* closest = pick(closest_, goal);
  const Solution* standing = pick(standing_, goal);
  return standing && goal.prefers_standing(standing->score(), closest->score()) ? standing
                                                                                : closest;
}

std::vector<Solution> ParetoArchive::best() const {
  std::vector<Solution> result;
  bool any_stands = false;
  for (const auto& [cables, closest] : closest_) {
    const auto standing = standing_.find(cables);
    const Solution& solution = standing == standing_.end() ? closest : standing->second;
    if (result.empty() || solution.max_percent < result.back().max_percent ||
        (solution.standing.holds() && !any_stands))
      result.push_back(solution);
    any_stands = any_stands || solution.standing.holds();
  }
  return result;
}

}  // namespace tencer::elimination
