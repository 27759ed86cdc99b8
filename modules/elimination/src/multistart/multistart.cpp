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

Requirements requirements_for(const Network& start, const model::Target& target,
                              const model::Rules& rules, const symmetry::Group* symmetry,
                              const EliminationOptions& options) {
  constexpr double softer = 0.2;  // than the start
  constexpr double moved = 2;     // times as far by errors as the start is
  const equilibrium::System system(start.structure);
  Workmanship workmanship = options.workmanship;
  workmanship.max_deviation =
      std::max(workmanship.max_deviation, moved * error_deviation(start, workmanship));
  return {.target = target,
          .rules = rules,
          .symmetry = symmetry,
          .min_eigenvalue = std::min(options.min_eigenvalue, softer * stiffest_eigenvalue(start)),
          .max_floating =
              equilibrium::floating_components(equilibrium::rigid_modes(system, start.state)),
          .workmanship = workmanship};
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

void Multistart::add_fitted(const Network& network, ParetoArchive& archive) {
  // What is found counts even if the search was stopped meanwhile.
  network::Control unstopped = control_;
  unstopped.stop = {};
  FittedNetwork fitted(network, requirements_, {}, options_.step, unstopped);
  for (const double stability_weight : options_.fit.stability_weights) {
    if (!fitted.usable()) break;
    const bool stopped = control_.stop.stop_requested();
    if (!stopped) fit_closely(fitted, options_.measure, stability_weight, options_.fit);
    Solution solution{.network = fitted.network(),
                      .max_percent = fitted.deviation().max_percent,
                      .rms_percent = fitted.deviation().rms_percent,
                      .smallest_eigenvalue = fitted.softest()};
    solution.standing =
        standing_of(solution.network, requirements_, options_.workmanship, control_.stop);
    const bool enough = solution.standing.holds() || control_.stop.stop_requested();
    archive.add(std::move(solution));
    if (enough) break;
  }
  count(fitted);
}

// Fits the networks of an elimination that may answer the goal: all of them, the first with few
// enough cables, or from the last back until one is close enough.
ParetoArchive Multistart::fit_answers(const std::vector<Network>& path) {
  const model::Goal& goal = options_.goal;
  ParetoArchive archive;
  for (auto network = path.rbegin(); network != path.rend(); ++network) {
    if (goal.by_number() && !goal.every_number) {
      // The one with the most of those that have few enough cables; when none has, the last.
      const auto more = std::next(network);
      if (cable_count(*network) > goal.cables && network != path.rbegin()) break;
      if (more != path.rend() && cable_count(*more) <= goal.cables) continue;
    }
    ParetoArchive fitted;
    add_fitted(*network, fitted);
    const Solution* solution = fitted.best_for(goal);
    const bool enough =
        solution && !goal.every_number && (goal.by_number() || goal.met(solution->score()));
    archive.add(fitted);
    if (enough) break;
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
  });
  ParetoArchive all;
  for (const auto& archive : archives) all.add(archive);
  return all;
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
  if (at.usable()) {
    bool in = insertion < 0;
    if (!in) {
      const auto insertions =
          best_insertions(at, candidates_, insertion + 1, options_.local_search);
      if (static_cast<int>(insertions.size()) > insertion)
        for (double part = 1; part > 0.05 && !in; part /= 4)
          in = at.restart(with_insertion(solution.network, insertions[insertion], part));
    }
    if (in) {
      at.refit(4);
      archive = fit_answers(eliminate_backward(at, descent(settings, percent), options_.removal));
    }
  }
  count(at);
  return archive;
}

// What there is to vary: of each archive the best, null where it has none with cables.
std::vector<const Solution*> Multistart::bests(std::span<const ParetoArchive> archives) const {
  std::vector<const Solution*> result;
  for (const ParetoArchive& archive : archives) {
    const Solution* best = archive.best_for(options_.goal);
    result.push_back(best && best->cables() > 0 ? best : nullptr);
  }
  return result;
}

void Multistart::perturb(std::span<ParetoArchive> archives, int round) {
  const auto found = bests(archives);
  std::vector<int> occupied;
  for (int i = 0; i < static_cast<int>(found.size()); ++i)
    if (found[i]) occupied.push_back(i);
  const int count = static_cast<int>(occupied.size());
  const int ways = static_cast<int>(options_.portfolio.size());
  std::vector<ParetoArchive> results(options_.portfolio.size());
  network::in_parallel(ways, options_.threads, [&](int k) {
    results[k] = perturbed(*found[occupied[k % count]], options_.portfolio[(k + round) % ways],
                           (k + ways * round) / count - 1);
  });
  for (int k = 0; k < ways; ++k) archives[occupied[k % count]].add(results[k]);
}

void Multistart::iterated_local_search(std::span<ParetoArchive> archives, int patience,
                                       const std::function<void()>& record) {
  const model::Goal& goal = options_.goal;
  if (goal.every_number) return;
  int waited = 0;
  for (int round = 0;
       round < options_.local_search.max_rounds && waited < patience && !recorder_.stopped();
       ++round) {
    std::vector<std::optional<model::Score>> before;
    for (const Solution* best : bests(archives))
      before.push_back(best ? std::optional(best->score()) : std::nullopt);
    if (std::ranges::none_of(before, [](const auto& best) { return best.has_value(); })) return;
    perturb(archives, waited);
    ++waited;
    for (std::size_t i = 0; i < archives.size(); ++i)
      if (before[i] && goal.improves(archives[i].best_for(goal)->score(), *before[i])) waited = 0;
    record();
  }
}

}  // namespace tencer::elimination
