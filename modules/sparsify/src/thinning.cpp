#include "thinning.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "fit.hpp"
#include "offers.hpp"
#include "parallel.hpp"

namespace tencer::sparsify {
namespace {

// Softness and finest unit of a descent (see DescentOptions), and how much further from the target
// it is steered than is wanted, for the last fit to make good (not when a number is asked for):
// which of them wins differs from target to target.
struct Temper {
  double softness = 0.0;
  double finest = 0.0;
  double looseness = 1.0;
};
constexpr Temper tempers[] = {{0.5, 1.0, 1.0}, {5.0, 0.2, 1.0},  {0.5, 1.0, 4.0},
                              {0.5, 0.2, 1.0}, {0.05, 1.0, 1.0}, {0.05, 1.0, 4.0}};
constexpr int temper_count = std::size(tempers);

}  // namespace

Thinning::Thinning(const Task& task, std::span<const springs::Cable> candidates,
                   const ThinOptions& options, const Control& control, const StageClock& clock)
    : task_(task),
      candidates_(candidates),
      options_(options),
      control_(control),
      clock_(clock),
      diagonal_(diagonal_of(task.target)) {}

Effort Thinning::take_effort() { return std::exchange(effort_, {}); }

void Thinning::count(const Walker& walker) {
  const std::lock_guard lock(mutex_);
  effort_.solves += walker.solves();
  effort_.iterations += walker.iterations();
}

void Thinning::report(const Walker& walker) {
  const std::lock_guard lock(mutex_);
  clock_.report(walker.cables(), walker.deviation().max_percent);
}

DescentOptions Thinning::descent(int temper, double percent) {
  const bool by_number = options_.cables > 0;
  constexpr double hopeless = 3;  // what is further away than this is not fitted back
  return {.percent = (by_number ? 1.0 : tempers[temper].looseness) * percent,
          .diagonal = diagonal_,
          .softness = tempers[temper].softness,
          .finest = tempers[temper].finest,
          .fewest = std::max(options_.cables, 1),
          .hopeless = by_number ? std::numeric_limits<double>::infinity() : hopeless * percent,
          .progress = [this](const Walker& at) { report(at); }};
}

void Thinning::add_fitted(const Network& network, const Task& task, Pool& pool) {
  // What is found counts even if the search was stopped meanwhile.
  Control unstopped = control_;
  unstopped.stop = {};
  Walker walker(network, task, {}, unstopped);
  if (walker.usable()) {
    if (!control_.stop.stop_requested()) fit(walker, task.target, options_.measure);
    pool.add({.network = walker.network(),
              .max_percent = walker.deviation().max_percent,
              .rms_percent = walker.deviation().rms_percent,
              .smallest_eigenvalue = walker.softest()});
  }
  count(walker);
}

// Fits the networks of a descent that may be the answer: all of them, the first with few enough
// cables, or from the last back until one is close enough.
Pool Thinning::choose(const std::vector<Network>& path, const Task& task) {
  Pool pool;
  for (auto network = path.rbegin(); network != path.rend(); ++network) {
    if (options_.cables > 0 && !options_.every_number) {
      // The one with the most of those that have few enough; when none has, the last.
      const int cables = static_cast<int>(network->structure.cables.size());
      const auto more = std::next(network);
      if (cables > options_.cables && network != path.rbegin()) break;
      if (more != path.rend() && static_cast<int>(more->structure.cables.size()) <= options_.cables)
        continue;
    }
    Pool fitted;
    add_fitted(*network, task, fitted);
    const Choice* choice = fitted.answer(options_);
    const bool enough = choice && !options_.every_number &&
                        (options_.cables > 0 || choice->max_percent <= options_.max_percent);
    pool.add(std::move(fitted));
    if (enough) break;
  }
  return pool;
}

Pool Thinning::descend_from(std::span<const Start> starts) {
  // With a number of cables given, distances only steer.
  constexpr double least_percent = 0.25;
  const double percent =
      options_.cables > 0 ? std::max(options_.max_percent, least_percent) : options_.max_percent;
  struct Job {
    const Start* start = nullptr;
    int temper = 0;
  };
  std::vector<Job> jobs;
  for (const Start& start : starts)
    for (int temper = 0; temper < std::min(start.descents, temper_count); ++temper)
      jobs.push_back({&start, temper});
  const int count_of_jobs = static_cast<int>(jobs.size());
  std::vector<Pool> pools(jobs.size());
  in_parallel(count_of_jobs, options_.threads, [&](int i) {
    const auto& [start, temper] = jobs[i];
    Task task = task_;
    if (start->symmetry) task.symmetry = start->symmetry;
    Walker walker(start->network, task, {}, control_);
    if (!walker.usable()) return;
    const auto path = descend(walker, descent(temper, percent));
    count(walker);
    pools[i] = choose(path, task);
  });
  Pool all;
  for (auto& pool : pools) all.add(std::move(pool));
  return all;
}

Pool Thinning::varied(const Choice& choice, int temper, int offer) {
  const double percent =
      std::max(options_.cables > 0 ? choice.max_percent : options_.max_percent, finest_percent);
  Walker walker(choice.network, task_,
                {.aim = {.unit = percent / 100 * diagonal_}, .softness = tempers[temper].softness},
                control_);
  Pool pool;
  if (walker.usable()) {
    const auto offers = best_offers(walker, task_, candidates_, offer + 1);
    bool in = false;
    if (static_cast<int>(offers.size()) > offer)
      for (double part = 1; part > 0.05 && !in; part /= 4)
        in = walker.restart(with_offer(choice.network, offers[offer], part));
    if (in) {
      walker.refit(4);
      pool = choose(descend(walker, descent(temper, percent)), task_);
    }
  }
  count(walker);
  return pool;
}

Pool Thinning::vary(const Choice& choice, int round) {
  std::vector<Pool> pools(temper_count);
  in_parallel(temper_count, options_.threads, [&](int i) {
    pools[i] = varied(choice, (i + round) % temper_count, i + temper_count * round);
  });
  Pool all;
  for (auto& pool : pools) all.add(std::move(pool));
  return all;
}

void Thinning::improve(Pool& pool, int patience, const std::function<void()>& record) {
  constexpr int most_rounds = 12;
  int waited = 0;
  for (int round = 0; round < most_rounds && waited < patience && !clock_.stopped() &&
                      !options_.every_number && pool.answer(options_);
       ++round) {
    const Choice best = *pool.answer(options_);
    if (cables_of(best) == 0) return;
    pool.add(vary(best, waited));
    waited = better(*pool.answer(options_), best, options_) ? 0 : waited + 1;
    record();
  }
}

}  // namespace tencer::sparsify
