#include <algorithm>
#include <optional>
#include <string>
#include <tencer/sparsify/balance.hpp>
#include <tencer/sparsify/rest_length.hpp>
#include <tencer/sparsify/search.hpp>
#include <utility>

#include "coarse.hpp"
#include "parallel.hpp"
#include "thinning.hpp"

namespace tencer::sparsify {
namespace {

struct Found {
  Pool pool{};
  double least_eigenvalue = 0.0;  // softer networks were not entered
};

// A network that balances the forces to a part of the distance that is accepted.
struct Balanced {
  const symmetry::Group* symmetry = nullptr;
  double part = 0.1;
  int descents = 1;
  StageResult outcome{};
};

// All of the search on rods of one resolution; its rows and its best network go to `result`.
Found search_on(const Problem& problem, const equilibrium::State& at_target,
                const symmetry::Group* symmetry, std::span<const symmetry::Group> hints,
                const ThinOptions& options, const Control& control, StageResult& result) {
  const Network bare{problem.structure, at_target};
  std::vector<Balanced> balanced{{.symmetry = symmetry, .part = 0.1, .descents = 6},
                                 {.symmetry = symmetry, .part = 0.5, .descents = 3}};
  if (!symmetry)
    for (const auto& hint : hints) balanced.push_back({&hint, 0.1, 2});
  const StageClock balancing("balance", control);
  in_parallel(static_cast<int>(balanced.size()), options.threads, [&](int i) {
    auto& [group, part, descents, outcome] = balanced[i];
    outcome = balance(bare, problem.target, problem.candidates, group,
                      {.percent = part * std::clamp(options.max_percent, 1e-2, 1.0)}, control);
  });
  // What is told of, and begun with, is the first that holds; failing all, the first.
  const auto holds = [](const Balanced& one) { return one.outcome.sound; };
  auto first = std::ranges::find_if(balanced, holds);
  if (first == balanced.end()) first = balanced.begin();
  result.network = first->outcome.network;
  result.interrupted = first->outcome.interrupted;
  // One row tells of all, which ran side by side.
  StageRow row = first->outcome.trace.back();
  row.seconds = balancing.seconds();
  row.solves = row.iterations = 0;
  for (const auto& one : balanced)
    for (const StageRow& own : one.outcome.trace) {
      row.solves += own.solves;
      row.iterations += own.iterations;
    }
  result.trace.push_back(std::move(row));
  if (!holds(*first) || result.interrupted) return {};
  std::vector<Start> starts;
  for (auto& [group, part, descents, outcome] : balanced)
    if (outcome.sound)
      starts.push_back(
          {.network = std::move(outcome.network), .descents = descents, .symmetry = group});

  StageClock clock("thin", control);
  const Task task{.target = problem.target,
                  .rules = problem.rules,
                  .symmetry = symmetry,
                  .least_eigenvalue = std::min(options.least_eigenvalue,
                                               0.2 * stiffest_eigenvalue(starts.front().network))};
  Thinning thinning(task, problem.candidates, options, control, clock);
  Found found{.least_eigenvalue = task.least_eigenvalue};
  found.pool = thinning.descend_from(starts);
  const auto record = [&] {
    if (const Choice* best = found.pool.answer(options)) result.network = best->network;
    clock.count(thinning.take_effort());
    result.trace.push_back(clock.row(result.network, problem.target));
  };
  record();
  thinning.improve(found.pool, 2, record);
  return found;
}

// Networks found on fewer vertices brought to the rods as they are, until one answers what is
// asked, and a few more: not every network that stands settles from the target.
void carry_over(const std::vector<Choice>& coarse, const equilibrium::Structure& bare,
                const Task& task, const ThinOptions& options, Thinning& thinning, Pool& pool) {
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
    thinning.add_fitted(carried(choice->network, bare), task, pool);
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
                    .least_eigenvalue = found.least_eigenvalue};
    Thinning thinning(task, candidates, options, control, clock);
    carry_over(found.pool.best(), bare.structure, task, options, thinning, pool);
    const auto record = [&] {
      result.network = pool.answer(options)->network;
      clock.count(thinning.take_effort());
      result.trace.push_back(clock.row(result.network, target));
    };
    if (const Choice* best = pool.answer(options)) {
      record();
      // What was lost on the way may be found again.
      if (found.pool.answer(options) && better(*found.pool.answer(options), *best, options))
        thinning.improve(pool, 1, record);
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
