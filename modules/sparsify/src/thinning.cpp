#include "thinning.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <tencer/equilibrium/built.hpp>
#include <tencer/sparsify/rest_length.hpp>
#include <utility>

#include "fit.hpp"
#include "offers.hpp"
#include "parallel.hpp"

namespace tencer::sparsify {
namespace {

// Softness and finest unit of a descent (see DescentOptions), and what it is steered by: a part of
// the accepted distance, since what stays closer on the way loses fewer ways on, or with a number
// of cables asked for so many times the distance that is wanted then. Which of them wins differs
// from target to target.
struct Temper {
  double softness = 0.0;
  double finest = 0.0;
  double part = 1.0;
  double times = 1.0;
};
constexpr Temper tempers[temper_count] = {{0.5, 1.0, 0.3, 1.0},  {5.0, 0.2, 0.3, 1.0},
                                          {0.5, 1.0, 1.0, 0.3},  {0.5, 0.2, 0.3, 1.0},
                                          {0.05, 1.0, 0.3, 1.0}, {0.05, 1.0, 1.0, 3.0}};

// Whether the walker's network as it is built, with inextensible cables, comes to rest where it is
// when it is let go at the target.
bool settles(const Walker& walker, const sensitivity::Target& target, const std::stop_token& stop) {
  constexpr double same_percent = 0.01;
  Network built = walker.network();
  const Eigen::VectorXd lengths = cable_lengths(built);
  for (Eigen::Index c = 0; c < lengths.size(); ++c)
    built.structure.cables[c].rest_length = lengths[c];
  const auto form = equilibrium::settle(
      built.structure, equilibrium::make_state(built.structure, target.points), {.stop = stop});
  if (!form.equilibrium.usable()) return false;
  sensitivity::Target pose = target;
  for (std::size_t r = 0; r < pose.points.size(); ++r) pose.points[r] = built.state[r].x;
  return 100 * sensitivity::deviation(pose, form.equilibrium.state).max <=
         same_percent * diagonal_of(target);
}

}  // namespace

Task task_for(const Network& start, const sensitivity::Target& target, const Rules& rules,
              const symmetry::Group* symmetry, const ThinOptions& options) {
  constexpr double softer = 0.2;  // than the start
  const equilibrium::System system(start.structure);
  return {
      .target = target,
      .rules = rules,
      .symmetry = symmetry,
      .least_eigenvalue = std::min(options.least_eigenvalue, softer * stiffest_eigenvalue(start)),
      .groups = equilibrium::free_groups(equilibrium::rigid_modes(system, start.state))};
}

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

double Thinning::steered_percent() const {
  // With a number of cables given, distances only steer.
  constexpr double least_percent = 0.25;
  return options_.cables > 0 ? std::max(options_.max_percent, least_percent) : options_.max_percent;
}

DescentOptions Thinning::descent(int temper, double percent) {
  const bool by_number = options_.cables > 0;
  constexpr double hopeless = 3;  // what is further away than this is not fitted back
  return {.percent = (by_number ? tempers[temper].times : tempers[temper].part) * percent,
          .diagonal = diagonal_,
          .softness = tempers[temper].softness,
          .finest = tempers[temper].finest,
          .fewest = std::max(options_.cables, 1),
          .hopeless = by_number ? std::numeric_limits<double>::infinity() : hopeless * percent,
          .progress = [this](const Walker& at) { report(at); }};
}

void Thinning::add_fitted(const Network& network, Pool& pool) {
  // What is found counts even if the search was stopped meanwhile.
  Control unstopped = control_;
  unstopped.stop = {};
  Walker walker(network, task_, {}, unstopped);
  // What does not settle from the target may once it resists its softest motions more.
  for (const double softness : {1e-2, 0.5}) {
    if (!walker.usable()) break;
    if (!control_.stop.stop_requested()) fit(walker, task_.target, options_.measure, softness);
    Choice choice{.network = walker.network(),
                  .max_percent = walker.deviation().max_percent,
                  .rms_percent = walker.deviation().rms_percent,
                  .smallest_eigenvalue = walker.softest(),
                  .settles = settles(walker, task_.target, control_.stop)};
    const bool enough = choice.settles || control_.stop.stop_requested();
    pool.add(std::move(choice));
    if (enough) break;
  }
  count(walker);
}

// Fits the networks of a descent that may be the answer: all of them, the first with few enough
// cables, or from the last back until one is close enough.
Pool Thinning::choose(const std::vector<Network>& path) {
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
    add_fitted(*network, fitted);
    const Choice* choice = fitted.answer(options_);
    const bool enough = choice && !options_.every_number &&
                        (options_.cables > 0 || choice->max_percent <= options_.max_percent);
    pool.add(fitted);
    if (enough) break;
  }
  return pool;
}

Pool Thinning::descend_from(std::span<const Start> starts) {
  const double percent = steered_percent();
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
    pools[i] = choose(path);
  });
  Pool all;
  for (const auto& pool : pools) all.add(pool);
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
    bool in = offer < 0;
    if (!in) {
      const auto offers = best_offers(walker, task_, candidates_, offer + 1);
      if (static_cast<int>(offers.size()) > offer)
        for (double part = 1; part > 0.05 && !in; part /= 4)
          in = walker.restart(with_offer(choice.network, offers[offer], part));
    }
    if (in) {
      walker.refit(4);
      pool = choose(descend(walker, descent(temper, percent)));
    }
  }
  count(walker);
  return pool;
}

// What there is to vary: of each island the best, null where it has none with cables.
std::vector<const Choice*> Thinning::bests(std::span<const Pool> islands) const {
  std::vector<const Choice*> result;
  for (const Pool& island : islands) {
    const Choice* best = island.answer(options_);
    result.push_back(best && cables_of(*best) > 0 ? best : nullptr);
  }
  return result;
}

void Thinning::vary(std::span<Pool> islands, int round) {
  const auto found = bests(islands);
  std::vector<int> inhabited;
  for (int i = 0; i < static_cast<int>(found.size()); ++i)
    if (found[i]) inhabited.push_back(i);
  const int count = static_cast<int>(inhabited.size());
  std::vector<Pool> pools(temper_count);
  in_parallel(temper_count, options_.threads, [&](int k) {
    pools[k] = varied(*found[inhabited[k % count]], (k + round) % temper_count,
                      (k + temper_count * round) / count - 1);
  });
  for (int k = 0; k < temper_count; ++k) islands[inhabited[k % count]].add(pools[k]);
}

void Thinning::improve(std::span<Pool> islands, int patience, const std::function<void()>& record) {
  constexpr int most_rounds = 12;
  if (options_.every_number) return;
  int waited = 0;
  for (int round = 0; round < most_rounds && waited < patience && !clock_.stopped(); ++round) {
    std::vector<std::optional<Choice>> before;
    for (const Choice* best : bests(islands))
      before.push_back(best ? std::optional(*best) : std::nullopt);
    if (std::ranges::none_of(before, [](const auto& best) { return best.has_value(); })) return;
    vary(islands, waited);
    ++waited;
    for (std::size_t i = 0; i < islands.size(); ++i)
      if (before[i] && better(*islands[i].answer(options_), *before[i], options_)) waited = 0;
    record();
  }
}

}  // namespace tencer::sparsify
