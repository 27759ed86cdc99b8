#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <tencer/sparsify/balance.hpp>
#include <tencer/sparsify/search.hpp>
#include <utility>

#include "coarse.hpp"
#include "neighbours.hpp"
#include "parallel.hpp"
#include "selection.hpp"
#include "thinning.hpp"

namespace tencer::sparsify {
namespace {

struct Found {
  Pool pool{};
  // Of the task.
  double least_eigenvalue = 0.0;
  int groups = 1;
};

// One row tells of several stages that ran side by side, `seconds` long; `told` has its figures.
StageRow together(const StageResult& told, std::span<const StageResult> all, double seconds) {
  StageRow row = told.trace.back();
  row.seconds = seconds;
  row.solves = row.iterations = 0;
  for (const StageResult& one : all)
    for (const StageRow& own : one.trace) {
      row.solves += own.solves;
      row.iterations += own.iterations;
    }
  return row;
}

// A part of the distance that is accepted, within reason.
double percent_of(const ThinOptions& options, double part) {
  return part * std::clamp(options.max_percent, 1e-2, 1.0);
}

// Networks that balance the forces to parts of the distance that is accepted, and how many descents
// each is worth. The first row and network of `result` are of the first that
// holds; failing all, of the first.
std::vector<Start> balanced(const Network& bare, const Problem& problem,
                            const symmetry::Group* symmetry, const ThinOptions& options,
                            const Control& control, StageResult& result) {
  struct Fineness {
    double part;
    int descents;
  };
  constexpr Fineness finenesses[] = {{0.1, 6}, {0.5, 3}};
  std::vector<StageResult> outcomes(std::size(finenesses));
  const StageClock clock("balance", control);
  in_parallel(static_cast<int>(outcomes.size()), options.threads, [&](int i) {
    outcomes[i] = balance(bare, problem.target, problem.candidates, symmetry,
                          {.percent = percent_of(options, finenesses[i].part)}, control);
  });
  auto told = std::ranges::find_if(outcomes, &StageResult::sound);
  if (told == outcomes.end()) told = outcomes.begin();
  result.network = told->network;
  result.interrupted = told->interrupted;
  result.trace.push_back(together(*told, outcomes, clock.seconds()));
  std::vector<Start> starts;
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    if (outcomes[i].sound)
      starts.push_back({.network = std::move(outcomes[i].network),
                        .descents = finenesses[i].descents,
                        .symmetry = symmetry});
  return starts;
}

// Networks of few orbits of each group; of a group whose few orbits do not hold, one that balances
// the forces.
std::vector<Start> symmetric(const Network& bare, const Problem& problem,
                             std::span<const symmetry::Group* const> groups, int most,
                             const ThinOptions& options, const Control& control, Effort& effort) {
  std::vector<std::vector<Start>> starts(groups.size());
  std::vector<Effort> efforts(groups.size());
  in_parallel(static_cast<int>(groups.size()), options.threads, [&](int i) {
    const symmetry::Group* group = groups[i];
    for (Network& network :
         select_few(bare, problem.target, problem.candidates, *group, most, control, efforts[i]))
      starts[i].push_back({.network = std::move(network), .descents = 1, .symmetry = group});
    if (!starts[i].empty()) return;
    StageResult outcome = balance(bare, problem.target, problem.candidates, group,
                                  {.percent = percent_of(options, 0.1)}, control);
    for (const StageRow& row : outcome.trace) {
      efforts[i].solves += row.solves;
      efforts[i].iterations += row.iterations;
    }
    if (outcome.sound)
      starts[i].push_back(
          {.network = std::move(outcome.network), .descents = 2, .symmetry = group});
  });
  std::vector<Start> all;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    effort.solves += efforts[i].solves;
    effort.iterations += efforts[i].iterations;
    std::ranges::move(starts[i], std::back_inserter(all));
  }
  return all;
}

// The same without cables between rods that are no neighbours, unless the rules say which to join.
Problem near_only(Problem problem) {
  if (!problem.rules.pairs)
    problem.candidates = among_neighbours(problem.candidates, problem.target.points);
  return problem;
}

// All of the search on rods of one resolution; its rows and its best network go to `result`.
Found search_on(const Problem& problem, const equilibrium::State& at_target,
                const symmetry::Group* symmetry, std::span<const symmetry::Group> hints,
                const ThinOptions& options, const Control& control, StageResult& result) {
  // Descents of the whole take long and end early when there are many rods.
  constexpr std::size_t several = 4;
  constexpr std::size_t many = 8;
  const std::size_t rods = symmetry || options.every_number ? 1 : problem.structure.rods.size();
  const Network bare{problem.structure, at_target};
  std::vector<Start> near;
  if (rods >= several)
    near = balanced(bare, near_only(problem), symmetry, options, control, result);
  std::vector<Start> full = near;
  if (rods < many || near.empty())
    full = balanced(bare, problem, symmetry, options, control, result);
  if (full.empty() || result.interrupted) return {};

  StageClock clock("thin", control);
  const Task task =
      task_for(full.front().network, problem.target, problem.rules, symmetry, options);
  Thinning thinning(task, problem.candidates, options, control, clock);
  for (Start& start : near) start = {.network = thinning.by_parts(start.network), .descents = 2};
  if (rods >= many)
    for (Start& start : full) start.descents = 1;
  std::vector<Start> few;
  if (rods < many) {
    std::vector<const symmetry::Group*> groups;
    if (symmetry)
      groups.push_back(symmetry);
    else
      for (const auto& hint : hints) groups.push_back(&hint);
    constexpr int few_at_least = 6;
    const int most = std::max({few_at_least, options.cables,
                               static_cast<int>(result.network.structure.cables.size()) / 2});
    Effort effort;
    few = symmetric(bare, problem, groups, most, options, control, effort);
    clock.count(effort);
  }
  std::ranges::move(near, std::back_inserter(few));

  Found found{.least_eigenvalue = task.least_eigenvalue, .groups = task.groups};
  Pool islands[] = {thinning.descend_from(full), thinning.descend_from(few)};
  const auto record = [&] {
    for (const Pool& island : islands) found.pool.add(island);
    if (const Choice* best = found.pool.answer(options)) result.network = best->network;
    clock.count(thinning.take_effort());
    result.trace.push_back(clock.row(result.network, problem.target));
  };
  record();
  thinning.improve(islands, rods < many ? 2 : 1, record);
  return found;
}

// Networks found on fewer vertices brought to the rods as they are, until one answers what is
// asked, and a few more: not every network that stands settles from the target.
void carry_over(const std::vector<Choice>& coarse, const equilibrium::Structure& bare,
                const ThinOptions& options, Thinning& thinning, Pool& pool) {
  constexpr double fits_closer = 1.2;  // after the last fit, perhaps
  const auto wanted = [&](const Choice& choice) {
    if (options.every_number) return true;
    return options.cables > 0 ? cables_of(choice) <= options.cables
                              : choice.max_percent <= fits_closer * options.max_percent;
  };
  const auto enough = [&] {
    const Choice* best = pool.answer(options);
    return best && !options.every_number &&
           (options.cables > 0 || best->max_percent <= options.max_percent);
  };
  std::vector<const Choice*> order;
  for (const Choice& choice : coarse)
    if (wanted(choice)) order.push_back(&choice);
  if (options.cables > 0) std::ranges::reverse(order);
  constexpr int more = 2;
  int spare = 0;
  for (const Choice* choice : order) {
    if (enough() && spare++ == more) return;
    thinning.add_fitted(carried(choice->network, bare), pool);
  }
}

int vertices_of(const equilibrium::Structure& structure) {
  int vertices = 0;
  for (const auto& rod : structure.rods) vertices += rod.vertices();
  return vertices;
}

}  // namespace

ThinResult search(const Network& bare, const sensitivity::Target& target, const Rules& rules,
                  std::span<const springs::Cable> candidates, const symmetry::Group* symmetry,
                  std::span<const symmetry::Group> hints, const ThinOptions& options,
                  const Control& control) {
  validate(options);
  validate(rules, bare.structure);
  StageResult result{.network = bare};
  Pool pool;
  if (const auto problem = coarsened(bare.structure, target, rules)) {
    std::vector<symmetry::Group> fewer;
    for (const auto& hint : hints)
      fewer.push_back(carried(hint, bare.structure.rods, problem->structure.rods));
    std::optional<symmetry::Group> kept;
    if (symmetry) kept = carried(*symmetry, bare.structure.rods, problem->structure.rods);
    Found found = search_on(*problem, carried(bare, problem->structure).state,
                            kept ? &*kept : nullptr, fewer, options, control, result);
    for (auto& row : result.trace)
      row.note += (row.note.empty() ? "" : "; ") + std::string("on ") +
                  std::to_string(vertices_of(problem->structure)) + " vertices";
    StageClock clock("fit", control);
    const Task task{.target = target,
                    .rules = rules,
                    .symmetry = symmetry,
                    .least_eigenvalue = found.least_eigenvalue,
                    .groups = found.groups};
    Thinning thinning(task, candidates, options, control, clock);
    carry_over(found.pool.best(), bare.structure, options, thinning, pool);
    const auto record = [&] {
      result.network = pool.answer(options)->network;
      clock.count(thinning.take_effort());
      result.trace.push_back(clock.row(result.network, target));
    };
    if (const Choice* best = pool.answer(options)) {
      record();
      // What was lost on the way may be found again.
      if (found.pool.answer(options) && better(*found.pool.answer(options), *best, options))
        thinning.improve({&pool, 1}, 1, record);
    }
  }
  if (!pool.answer(options)) {
    const Problem problem{.structure = bare.structure,
                          .target = target,
                          .rules = rules,
                          .candidates = {candidates.begin(), candidates.end()}};
    pool = search_on(problem, bare.state, symmetry, hints, options, control, result).pool;
  }
  StageClock clock("thin", control);
  finish(result, target, clock);
  return {.stage = std::move(result), .choices = pool.best()};
}

}  // namespace tencer::sparsify
