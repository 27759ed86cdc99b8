#include "multistart/multistart.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <tencer/equilibrium/rigid_modes.hpp>
#include <tencer/network/parallel.hpp>
#include <tencer/network/rest_length.hpp>
#include <utility>

#include "moves/insertion.hpp"
#include "state/final_fit.hpp"
#include "state/standing.hpp"

namespace tencer::elimination {

using network::Network;

namespace {

// Whether the answer is better by more than distance within the accepted error, or what to go on
// from nearer to standing.
bool improved(const ParetoArchive& before, const ParetoArchive& after, const model::Goal& goal) {
  constexpr double clearly = 0.9;
  const Solution* best = before.best_for(goal);
  if (!best) return false;
  const model::Score old_score = best->score();
  const model::Score new_score = after.best_for(goal)->score();
  const bool only_closer = !goal.by_number() && goal.met(old_score) &&
                           new_score.cables == old_score.cables &&
                           new_score.footing == old_score.footing;
  if (!only_closer && goal.improves(new_score, old_score)) return true;
  const Standing& base = before.base_for(goal)->standing;
  const Standing& next = after.base_for(goal)->standing;
  return base.footing == model::Footing::keeps && next.footing == model::Footing::keeps &&
         next.deviation < clearly * base.deviation;
}

// The first, and those that have lost a fifth of the cables since the one before.
std::vector<Network> thinned(const std::vector<Network>& path) {
  constexpr double part = 0.8;
  std::vector<Network> kept;
  for (const Network& network : path)
    if (kept.empty() || cable_count(network) <= part * cable_count(kept.back()))
      kept.push_back(network);
  return kept;
}

}  // namespace

Requirements requirements_for(const Network& start, const model::Target& target,
                              const model::Rules& rules, const symmetry::Group* symmetry,
                              const EliminationOptions& options) {
  constexpr double softer = 0.2;  // than the start
  constexpr double moved = 2;     // times as far by errors as the start is
  const equilibrium::System system(start.structure);
  Workmanship workmanship = options.workmanship;
  workmanship.max_deviation =
      std::max(workmanship.max_deviation, moved * error_deviation(start, target, workmanship));
  return {.target = target,
          .rules = rules,
          .symmetry = symmetry,
          .min_eigenvalue = std::min(options.min_eigenvalue, softer * stiffest_eigenvalue(start)),
          .max_floating =
              equilibrium::floating_components(equilibrium::rigid_modes(system, start.state)),
          .workmanship = workmanship,
          .standing_deviation = options.workmanship.max_deviation};
}

Multistart::Multistart(const Requirements& requirements, std::span<const springs::Cable> candidates,
                       const EliminationOptions& options, const network::Control& control,
                       const network::StageRecorder& recorder)
    : requirements_(requirements),
      candidates_(candidates),
      options_(options),
      control_(control),
      recorder_(recorder),
      diagonal_(model::diagonal(requirements.target)) {}

network::SolveCounts Multistart::take_counts() { return std::exchange(counts_, {}); }

void Multistart::count(const FittedNetwork& fitted) {
  const std::lock_guard lock(mutex_);
  counts_ += fitted.counts();
}

void Multistart::report(const FittedNetwork& fitted) const {
  recorder_.report(fitted.cables(), fitted.deviation().max_percent);
}

FittedNetwork Multistart::fitted(const Network& network, const Requirements& requirements,
                                 const Objective& objective) const {
  return {network, requirements, objective, options_.step, control_};
}

double Multistart::aim_percent() const {
  // With a number of cables given the distance only steers, and it should not steer too tightly.
  constexpr double min_aim_percent = 0.25;
  const model::Goal& goal = options_.goal;
  return goal.by_number() ? std::max(goal.max_error_percent, min_aim_percent)
                          : goal.max_error_percent;
}

Descent Multistart::descent(const DescentSettings& settings, double max_error_percent) const {
  const bool by_number = options_.goal.by_number();
  constexpr double max_refit = 3;  // times the error: what is further away is not fitted back
  return {.aim_percent = (by_number ? settings.times : settings.part) * max_error_percent,
          .diagonal = diagonal_,
          .stability_weight = settings.stability_weight,
          .min_unit = settings.min_unit,
          .min_cables = std::max(options_.goal.cables, 1),
          .max_percent =
              by_number ? std::numeric_limits<double>::infinity() : max_refit * max_error_percent,
          .progress = [this](const FittedNetwork& at) { report(at); }};
}

void Multistart::add_fitted(const Network& network, ParetoArchive& archive, Fit fit) {
  // What is found counts even if the search was stopped meanwhile.
  network::Control unstopped = control_;
  unstopped.stop = {};
  FittedNetwork fitted(network, requirements_, {}, options_.step, unstopped);
  const model::Goal& goal = options_.goal;
  const double accepted = goal.by_number() ? 0.0 : goal.max_error_percent;
  std::vector<Solution> found;
  for (const auto& [stability_weight, min_unit] : options_.fit.attempts) {
    if (!fitted.usable()) break;
    const bool stopped = control_.stop.stop_requested();
    // A fit of many cables takes minutes, for nothing where they are close enough as they are.
    const bool pays = goal.by_number() ? fitted.cables() <= goal.cables
                                       : fitted.deviation().max_percent > accepted;
    if (!stopped || (fit == Fit::always && pays))
      fit_closely(fitted, options_.measure, stability_weight, min_unit * accepted, options_.fit);
    Solution& solution = found.emplace_back(Solution{.network = fitted.network(),
                                                     .max_percent = fitted.deviation().max_percent,
                                                     .rms_percent = fitted.deviation().rms_percent,
                                                     .smallest_eigenvalue = fitted.softest()});
    // What is too far away is no answer, however it stands.
    if (stopped || (!goal.every_number && !goal.met(solution.score()))) break;
    solution.standing = standing_of(solution.network, requirements_, control_.stop);
    if (solution.standing.stands()) break;
  }
  count(fitted);
  look_for_footing(found);
  for (const Solution& solution : found) archive.add(solution);
}

// When none stands, whether the one that errors move least keeps its pose.
void Multistart::look_for_footing(std::vector<Solution>& found) const {
  Solution* firmest = nullptr;
  for (Solution& solution : found) {
    if (solution.standing.stands()) return;
    if ((options_.goal.every_number || options_.goal.met(solution.score())) &&
        (!firmest || solution.standing.deviation < firmest->standing.deviation))
      firmest = &solution;
  }
  if (firmest && keeps_its_pose(firmest->network, requirements_, control_.stop))
    firmest->standing.footing = model::Footing::keeps;
}

// Fits the networks of an elimination that may answer the goal: all of them, the first with few
// enough cables, or from the last back until one is close enough and stands; ever further back, as
// what has many more cables moves less.
ParetoArchive Multistart::fit_answers(const std::vector<Network>& path) {
  const model::Goal& goal = options_.goal;
  ParetoArchive archive;
  // Where time was short the first, with the most cables, may be all that holds.
  if (control_.stop.stop_requested()) add_fitted(path.front(), archive);
  if (goal.by_number() && !goal.every_number) {
    // The one with the most of those that have few enough cables; when none has, the last.
    const auto few = std::ranges::find_if(
        path, [&](const Network& network) { return cable_count(network) <= goal.cables; });
    add_fitted(few == path.end() ? path.back() : *few, archive);
    return archive;
  }
  int further = options_.fit.further;
  std::ptrdiff_t step = 1;
  for (auto at = std::ssize(path) - 1; at >= 0; at -= step) {
    ParetoArchive fitted;
    add_fitted(path[at], fitted);
    const Solution* solution = fitted.best_for(goal);
    archive.add(fitted);
    if (goal.every_number || !solution || !goal.met(solution->score())) continue;
    if (solution->standing.stands() || control_.stop.stop_requested()) break;
    if (further-- <= 0) step *= 2;
  }
  return archive;
}

ParetoArchive Multistart::eliminate_from(std::span<const Start> starts) {
  struct Job {
    const Start* start = nullptr;
    int settings = 0;
  };
  std::vector<Job> jobs;
  for (const Start& start : starts)
    for (int k = 0; k < std::min(start.descents, static_cast<int>(options_.portfolio.size())); ++k)
      jobs.push_back({&start, k});
  std::vector<ParetoArchive> archives(jobs.size());
  std::vector<Way> ways(jobs.size());
  network::in_parallel(static_cast<int>(jobs.size()), options_.threads, [&](int i) {
    const auto& [start, settings] = jobs[i];
    Requirements requirements{requirements_};
    if (start->symmetry) requirements.symmetry = start->symmetry;
    FittedNetwork at = fitted(start->network, requirements);
    if (!at.usable()) return;
    const auto path = eliminate_backward(at, descent(options_.portfolio[settings], aim_percent()),
                                         options_.removal);
    count(at);
    archives[i] = fit_answers(path);
    ways[i].networks = thinned(path);
    if (const Solution* best = archives[i].best_for(options_.goal)) ways[i].found = best->score();
  });
  ParetoArchive all;
  for (const auto& archive : archives) all.add(archive);
  for (Way& way : ways) keep_better(way);
  return all;
}

void Multistart::keep_better(Way& way) {
  if (!way.found) return;
  if (!best_way_.found || options_.goal.improves(*way.found, *best_way_.found))
    best_way_ = std::move(way);
}

// Puts one of the best cables in; what does not stand is braced every other time. false: there is
// none, or the network does not bear it.
bool Multistart::insert(FittedNetwork& at, const Solution& solution, int insertion) const {
  const bool stands = solution.standing.stands();
  const auto best = stands || insertion % 2 == 1 ? best_insertions : best_braces;
  const int which = stands ? insertion : insertion / 2;
  const auto insertions = best(at, candidates_, which + 1, options_.local_search);
  if (static_cast<int>(insertions.size()) <= which) return false;
  for (double part = 1; part > 0.05; part /= 4)
    if (at.restart(with_insertion(solution.network, insertions[which], part))) return true;
  return false;
}

ParetoArchive Multistart::perturbed(const Solution& solution, const DescentSettings& settings,
                                    int insertion) {
  const model::Goal& goal = options_.goal;
  const double percent = std::max(goal.by_number() ? solution.max_percent : goal.max_error_percent,
                                  min_distance_percent);
  FittedNetwork at = fitted(
      solution.network, requirements_,
      {.norm = {.unit = percent / 100 * diagonal_}, .stability_weight = settings.stability_weight});
  ParetoArchive archive;
  if (at.usable() && (insertion < 0 || insert(at, solution, insertion))) {
    at.refit(4);
    // A cable more may be what it stands by.
    if (insertion >= 0 && !solution.standing.stands()) add_fitted(at.network(), archive);
    archive.add(fit_answers(eliminate_backward(at, descent(settings, percent), options_.removal)));
  }
  count(at);
  return archive;
}

bool Multistart::perturb(std::span<ParetoArchive> archives, int round) {
  std::vector<Solution> bases;  // of each archive that has something to vary
  std::vector<int> occupied;
  for (int i = 0; i < static_cast<int>(archives.size()); ++i)
    if (const Solution* base = archives[i].base_for(options_.goal); base && base->cables() > 0) {
      bases.push_back(*base);
      occupied.push_back(i);
    }
  if (occupied.empty()) return false;
  const int count = static_cast<int>(occupied.size());
  const int ways = static_cast<int>(options_.portfolio.size());
  std::vector<ParetoArchive> results(options_.portfolio.size());
  network::in_parallel(ways, options_.threads, [&](int k) {
    results[k] = perturbed(bases[k % count], options_.portfolio[(k + round) % ways],
                           (k + ways * round) / count - 1);
  });
  for (int k = 0; k < ways; ++k) archives[occupied[k % count]].add(results[k]);
  return true;
}

void Multistart::iterated_local_search(std::span<ParetoArchive> archives, int patience,
                                       const std::function<void()>& record) {
  const model::Goal& goal = options_.goal;
  if (goal.every_number) return;
  int waited = 0;
  for (int round = 0;
       round < options_.local_search.max_rounds && waited < patience && !recorder_.stopped();
       ++round) {
    const std::vector<ParetoArchive> before(archives.begin(), archives.end());
    if (!perturb(archives, waited)) return;
    ++waited;
    for (std::size_t i = 0; i < archives.size(); ++i)
      if (improved(before[i], archives[i], goal)) waited = 0;
    record();
  }
}

void record(const ParetoArchive& archive, Multistart& multistart, const model::Target& target,
            network::StageRecorder& recorder, network::StageResult& result) {
  for (const Network& network : multistart.take_way()) recorder.pass(network, target);
  if (const Solution* best = archive.best_for(multistart.options().goal))
    result.network = best->network;
  recorder.add(multistart.take_counts());
  result.trace.push_back(recorder.row(result.network, target));
}

}  // namespace tencer::elimination
