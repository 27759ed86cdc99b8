#include "multistart/pareto_archive.hpp"

#include <iterator>

namespace tencer::elimination {
namespace {

using ByCables = std::map<int, Solution>;

void keep_closest(const Solution& solution, ByCables& closest) {
  const auto [at, added] = closest.try_emplace(solution.cables(), solution);
  if (!added && solution.max_percent < at->second.max_percent) at->second = solution;
}

const Solution* pick(const ByCables& closest, const model::Goal& goal) {
  std::vector<model::Score> scores;
  for (const auto& [cables, solution] : closest) scores.push_back(solution.score());
  const int at = goal.pick(scores);
  return at < 0 ? nullptr : &std::next(closest.begin(), at)->second;
}

}  // namespace

void ParetoArchive::add(const Solution& solution) {
  for (std::size_t footing = 0; footing <= static_cast<std::size_t>(solution.standing.footing);
       ++footing)
    keep_closest(solution, closest_[footing]);
  if (solution.standing.footing == model::Footing::keeps &&
      (!least_moved_ || solution.standing.deviation < least_moved_->standing.deviation))
    least_moved_ = solution;
}

void ParetoArchive::add(const ParetoArchive& other) {
  for (std::size_t footing = 0; footing < closest_.size(); ++footing)
    for (const auto& [cables, solution] : other.closest_[footing])
      keep_closest(solution, closest_[footing]);
  if (other.least_moved_) add(*other.least_moved_);
}

const Solution* ParetoArchive::best_for(const model::Goal& goal) const {
  const Solution* best = nullptr;
  for (const ByCables& closest : closest_) {
    const Solution* firmer = pick(closest, goal);
    if (!best || (firmer && goal.prefers_footing(firmer->score(), best->score()))) best = firmer;
  }
  return best;
}

const Solution* ParetoArchive::base_for(const model::Goal& goal) const {
  const Solution* best = best_for(goal);
  return best && !best->standing.stands() && least_moved_ && goal.met(least_moved_->score())
             ? &*least_moved_
             : best;
}

std::vector<Solution> ParetoArchive::best() const {
  std::vector<Solution> result;
  auto firmest = model::Footing::none;
  for (const auto& [cables, closest] : closest_.front()) {
    const Solution* solution = &closest;
    for (const ByCables& firmer : closest_)
      if (const auto found = firmer.find(cables); found != firmer.end()) solution = &found->second;
    const model::Footing footing = solution->standing.footing;
    if (result.empty() || solution->max_percent < result.back().max_percent || footing > firmest)
      result.push_back(*solution);
    firmest = std::max(firmest, footing);
  }
  return result;
}

}  // namespace tencer::elimination
