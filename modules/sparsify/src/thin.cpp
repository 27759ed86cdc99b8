#include <algorithm>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/sparsify/rest_length.hpp>
#include <tencer/sparsify/thin.hpp>

#include "descent.hpp"
#include "offers.hpp"
#include "parallel.hpp"
#include "stage_clock.hpp"

namespace tencer::sparsify {
namespace {

// Softness and finest unit of the descents (see DescentOptions): which of them wins differs from
// target to target.
struct Temper {
  double softness = 0.0;
  double finest = 0.0;
};
constexpr Temper tempers[] = {{0.5, 1.0}, {5.0, 0.2}, {0.5, 0.2}, {0.05, 1.0}};
constexpr int descents = std::size(tempers);

double diagonal_of(const sensitivity::Target& target) {
  std::vector<geometry::Polyline> curves;
  for (const auto& points : target.points) curves.push_back({.points = points});
  return geometry::bounding_box_diagonal(curves);
}

// Of each number of cables the closest network.
using Pool = std::map<int, Choice>;

void offer(Pool& pool, Choice choice) {
  const int cables = static_cast<int>(choice.network.structure.cables.size());
  const auto [at, added] = pool.try_emplace(cables, choice);
  if (!added && choice.max_percent < at->second.max_percent) at->second = std::move(choice);
}

class Thinning {
 public:
  Thinning(const Task& task, std::span<const springs::Cable> candidates, const ThinOptions& options,
           const Control& control, const StageClock& clock)
      : task_(task),
        candidates_(candidates),
        options_(options),
        control_(control),
        clock_(clock),
        diagonal_(diagonal_of(task.target)) {}

  Effort effort() const { return effort_; }

  // All descents from a network, and of each the networks that answer what is asked.
  Pool descend_from(const Network& network, int fewest);

  // The network fitted as closely as it goes.
  std::optional<Choice> fitted(const Network& network);

  // A closer network with as many cables: one more in, another one out.
  std::optional<Choice> swapped(const Choice& choice);

 private:
  Pool choose(const std::vector<Network>& path);
  void count(const Walker& walker);
  void report(const Walker& walker);

  Task task_;
  std::span<const springs::Cable> candidates_;
  const ThinOptions& options_;
  const Control& control_;
  const StageClock& clock_;
  double diagonal_;
  std::mutex mutex_;
  Effort effort_;
};

void Thinning::count(const Walker& walker) {
  const std::lock_guard lock(mutex_);
  effort_.solves += walker.solves();
  effort_.iterations += walker.iterations();
}

void Thinning::report(const Walker& walker) {
  const std::lock_guard lock(mutex_);
  clock_.report(walker.cables(), walker.deviation().max_percent);
}

std::optional<Choice> Thinning::fitted(const Network& network) {
  constexpr double softness = 1e-2;
  constexpr double nearly_largest = 8;  // the power of the norm
  constexpr int rounds = 3;
  Walker walker(network, task_, {}, control_);
  if (!walker.usable()) {
    count(walker);
    return std::nullopt;
  }
  const bool largest = options_.measure == Measure::largest;
  for (int round = 0; round < rounds; ++round) {
    const auto error = [&] {
      return largest ? walker.deviation().max_percent : walker.deviation().rms_percent;
    };
    const double before = error();
    walker.set({.aim = {.unit = std::max(before, finest_percent) / 100 * diagonal_,
                        .power = largest && round > 0 ? nearly_largest : 2.0},
                .softness = softness});
    walker.refit(6, 0.03);
    if (round > 0 && error() > 0.95 * before) break;
  }
  count(walker);
  return Choice{.network = walker.network(),
                .max_percent = walker.deviation().max_percent,
                .rms_percent = walker.deviation().rms_percent,
                .smallest_eigenvalue = walker.softest()};
}

// Fits the networks of a descent that may be the answer: all of them, the first with few enough
// cables, or from the last back until one is close enough.
Pool Thinning::choose(const std::vector<Network>& path) {
  Pool pool;
  for (auto network = path.rbegin(); network != path.rend(); ++network) {
    if (control_.stop.stop_requested()) {
      // There is no time to fit: the first that is close enough as it is.
      const auto deviation = sensitivity::deviation(task_.target, network->state);
      if (deviation.max_percent > options_.max_percent) continue;
      offer(pool, {.network = *network,
                   .max_percent = deviation.max_percent,
                   .rms_percent = deviation.rms_percent});
      break;
    }
    const int cables = static_cast<int>(network->structure.cables.size());
    if (options_.cables > 0 && !options_.every_number) {
      // The one with the most of those that have few enough; when none has, the last.
      const auto more = std::next(network);
      if (cables > options_.cables && network != path.rbegin()) break;
      if (more != path.rend() && static_cast<int>(more->structure.cables.size()) <= options_.cables)
        continue;
    }
    auto choice = fitted(*network);
    if (!choice) continue;
    const bool close = choice->max_percent <= options_.max_percent;
    offer(pool, std::move(*choice));
    if (!options_.every_number && (options_.cables > 0 || close)) break;
  }
  return pool;
}

Pool Thinning::descend_from(const Network& network, int fewest) {
  std::vector<Pool> pools(descents);
  in_parallel(descents, options_.threads, [&](int i) {
    // With a number of cables given, distances only steer.
    constexpr double least_percent = 0.25;
    const bool by_number = options_.cables > 0;
    const DescentOptions descent{
        .percent = by_number ? std::max(options_.max_percent, least_percent) : options_.max_percent,
        .diagonal = diagonal_,
        .softness = tempers[i].softness,
        .finest = tempers[i].finest,
        .fewest = fewest,
        .hopeless = by_number ? std::numeric_limits<double>::infinity() : DescentOptions{}.hopeless,
        .progress = [&](const Walker& at) { report(at); }};
    Walker walker(network, task_, {}, control_);
    if (!walker.usable()) return;
    const auto path = descend(walker, descent);
    count(walker);
    pools[i] = choose(path);
  });
  Pool all;
  for (auto& pool : pools)
    for (auto& [cables, choice] : pool) offer(all, std::move(choice));
  return all;
}

std::optional<Choice> Thinning::swapped(const Choice& choice) {
  const int cables = static_cast<int>(choice.network.structure.cables.size());
  const Drive drive{.aim = {.unit = std::max(choice.max_percent, finest_percent) / 100 * diagonal_},
                    .softness = 0.05};
  Walker walker(choice.network, task_, drive, control_);
  if (!walker.usable()) return std::nullopt;
  const auto more = best_offer(walker, task_.target, task_.rules, candidates_);
  std::optional<Choice> result;
  if (more) {
    bool in = false;
    for (double part = 1; part > 0.05 && !in; part /= 4)
      in = walker.restart(with_cable(choice.network, more->cable, part * more->tension));
    if (in) {
      walker.refit(4);
      const auto path = descend(walker, {.percent = choice.max_percent,
                                         .diagonal = diagonal_,
                                         .softness = 0.05,
                                         .finest = 0.5,
                                         .fewest = cables,
                                         .tries = 6});
      if (static_cast<int>(path.back().structure.cables.size()) <= cables)
        result = fitted(path.back());
    }
  }
  count(walker);
  if (result && result->max_percent < choice.max_percent) return result;
  return std::nullopt;
}

// What is asked for, or what comes nearest to it.
const Choice* answer(const Pool& pool, const ThinOptions& options) {
  const Choice* best = nullptr;
  for (const auto& [cables, choice] : pool) {
    if (options.cables == 0 && choice.max_percent <= options.max_percent) return &choice;
    if (options.cables > 0 && cables > options.cables && best) break;
    if (!best || choice.max_percent < best->max_percent) best = &choice;
  }
  return best;
}

int count_of(const Choice& choice) {
  return static_cast<int>(choice.network.structure.cables.size());
}

}  // namespace

ThinResult thin(const Network& network, const sensitivity::Target& target, const Rules& rules,
                std::span<const springs::Cable> candidates, const symmetry::Group* symmetry,
                const ThinOptions& options, const Control& control) {
  core::require(options.max_percent > 0, "ThinOptions::max_percent must be positive");
  core::require(options.cables >= 0, "ThinOptions::cables must not be negative");
  validate(rules, network.structure);
  StageClock clock("thin", control);
  if (auto refusal = refused(network, target, clock)) return {.stage = std::move(*refusal)};
  const Task task{
      .target = target,
      .rules = rules,
      .symmetry = symmetry,
      .least_eigenvalue = std::min(options.least_eigenvalue, 0.2 * stiffest_eigenvalue(network))};
  Thinning thinning(task, candidates, options, control, clock);
  StageResult result{.network = network};
  const auto add_row = [&](const Pool& pool) {
    if (const Choice* best = answer(pool, options)) result.network = best->network;
    clock.count(thinning.effort());
    result.trace.push_back(clock.row(result.network, target));
  };

  Pool pool = thinning.descend_from(network, std::max(options.cables, 1));
  add_row(pool);
  // Further down from the best, which was fitted more closely than descents do; with a given number
  // of cables, sideways.
  constexpr int rounds = 3;
  for (int round = 0; round < rounds && !clock.stopped() && !options.every_number; ++round) {
    const Choice* best = answer(pool, options);
    if (!best) break;
    const int cables = count_of(*best);
    if (options.cables > 0) {
      auto next = thinning.swapped(*best);
      if (!next) break;
      offer(pool, std::move(*next));
    } else {
      if (best->max_percent > options.max_percent || cables == 1) break;
      for (auto& [number, choice] : thinning.descend_from(best->network, 1))
        offer(pool, std::move(choice));
      if (count_of(*answer(pool, options)) == cables) break;
    }
    add_row(pool);
  }
  finish(result, target, clock);

  ThinResult thinned{.stage = std::move(result)};
  for (auto& [cables, choice] : pool)
    if (thinned.choices.empty() || choice.max_percent < thinned.choices.back().max_percent)
      thinned.choices.push_back(std::move(choice));
  return thinned;
}

}  // namespace tencer::sparsify
