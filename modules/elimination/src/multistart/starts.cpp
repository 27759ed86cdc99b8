#include "multistart/starts.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <tencer/ground_structure/beam_search.hpp>
#include <tencer/ground_structure/dense_springs.hpp>
#include <tencer/ground_structure/force_balance.hpp>
#include <tencer/ground_structure/neighbours.hpp>
#include <tencer/ground_structure/problem_symmetry.hpp>
#include <tencer/network/parallel.hpp>
#include <tencer/network/rest_length.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <tencer/sparsify/greedy.hpp>
#include <tencer/symmetry/subgroups.hpp>
#include <utility>

namespace tencer::elimination {
namespace {

using ground_structure::Problem;
using network::Network;
using network::StageResult;

// One row tells of several stages that ran side by side, `seconds` long; `told` has its figures.
model::StageRow together(const StageResult& told, std::span<const StageResult> all,
                         double seconds) {
  model::StageRow row = told.trace.back();
  row.seconds = seconds;
  row.solves = row.iterations = 0;
  for (const StageResult& one : all)
    for (const model::StageRow& own : one.trace) {
      row.solves += own.solves;
      row.iterations += own.iterations;
    }
  return row;
}

double balance_percent(const EliminationOptions& options, double part) {
  const StartOptions& start = options.start;
  return part * std::clamp(options.goal.max_error_percent, start.min_error_percent,
                           start.max_error_percent);
}

// Ties that deform the rods by a good part of the accepted error stay taut when they are cut a
// little long; in EI / L^2, of which ten move a ring by half a percent of its length.
double tie_tension(const EliminationOptions& options) { return 10 * balance_percent(options, 1.0); }

// Networks of few orbits of a group; when its few orbits do not hold, one that balances the forces.
std::vector<Start> symmetric_starts(const Problem& problem, const symmetry::Group& group,
                                    int max_cables, const EliminationOptions& options,
                                    const network::Control& control, network::SolveCounts& counts) {
  std::vector<Start> starts;
  for (Network& network : beam_search(problem, group, {.max_cables = max_cables}, control, counts))
    starts.push_back({.network = std::move(network), .descents = 1, .symmetry = &group});
  if (!starts.empty()) return starts;
  const double part = options.start.balances.front().part;
  StageResult outcome = force_balance(
      problem, &group,
      {.max_error_percent = balance_percent(options, part), .tie_tension = tie_tension(options)},
      control);
  for (const model::StageRow& row : outcome.trace)
    counts += {.solves = row.solves, .iterations = row.iterations};
  if (outcome.valid())
    starts.push_back({.network = std::move(outcome.network), .descents = 2, .symmetry = &group});
  return starts;
}

// Networks that balance the forces to parts of the error that is accepted. The first row and
// network of `result` are of the first that is valid; failing all, of the first.
std::vector<Start> balanced_starts(const Problem& problem, const EliminationOptions& options,
                                   const network::Control& control, StageResult& result) {
  const auto& balances = options.start.balances;
  std::vector<StageResult> outcomes(balances.size());
  const network::StageRecorder recorder("balance", control);
  network::in_parallel(static_cast<int>(outcomes.size()), options.threads, [&](int i) {
    outcomes[i] = force_balance(problem, problem.group(),
                                {.max_error_percent = balance_percent(options, balances[i].part),
                                 .tie_tension = tie_tension(options)},
                                control);
  });
  auto told = std::ranges::find_if(outcomes, &StageResult::valid);
  if (told == outcomes.end()) told = outcomes.begin();
  result.network = told->network;
  result.interrupted = told->interrupted;
  result.trace.push_back(together(*told, outcomes, recorder.seconds()));
  std::vector<Start> starts;
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    if (outcomes[i].valid())
      starts.push_back({.network = std::move(outcomes[i].network),
                        .descents = balances[i].descents,
                        .symmetry = problem.group()});
  return starts;
}

// Networks of few orbits of each group, side by side. They refer to the groups.
std::vector<Start> symmetric_starts(const Problem& problem,
                                    std::span<const symmetry::Group* const> groups, int max_cables,
                                    const EliminationOptions& options,
                                    const network::Control& control, network::SolveCounts& counts) {
  std::vector<std::vector<Start>> starts(groups.size());
  std::vector<network::SolveCounts> own(groups.size());
  network::in_parallel(static_cast<int>(groups.size()), options.threads, [&](int i) {
    starts[i] = symmetric_starts(problem, *groups[i], max_cables, options, control, own[i]);
  });
  std::vector<Start> all;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    counts += own[i];
    std::ranges::move(starts[i], std::back_inserter(all));
  }
  return all;
}

// Groups that structure and target nearly have: symmetric networks are found sooner and are often
// good.
std::vector<symmetry::Group> symmetry_seeds(const Problem& problem, const StartOptions& options) {
  if (problem.symmetry || options.max_seed_order == 0) return {};
  return symmetry::subgroups(ground_structure::detected(problem, options.nearly_symmetric).group,
                             options.max_seed_order);
}

// The problem without cables between rods that are no neighbours, unless the rules say which rods
// to join.
Problem among_neighbours_only(Problem problem) {
  if (!problem.rules.pairs)
    problem.candidates =
        ground_structure::among_neighbours(problem.candidates, problem.target.points);
  return problem;
}

// The paper's start (sections 5.1 and 5.2): all candidates as springs, less those that push, then
// less the weakest while the rods stay near. What holds is stable, if not near; eliminations draw
// it to the target. Takes ten times as long as a balance, and more.
std::vector<Start> sprung_starts(const Problem& problem, const EliminationOptions& options,
                                 const network::Control& control, StageResult& result) {
  Network network = problem.bare();
  network.structure.cables =
      ground_structure::dense_springs(problem.structure, problem.target.points, problem.candidates);
  StageResult pulling = sparsify::prune(network, problem.target,
                                        {.hardest_part = 0.5, .all_or_nothing = true}, control);
  std::ranges::move(pulling.trace, std::back_inserter(result.trace));
  if (!pulling.valid()) return {};
  int vertices = 0;
  for (const auto& rod : problem.structure.rods) vertices += rod.vertices();
  // Deviations of this root mean square, as the threshold counts them.
  const double rms = options.goal.max_error_percent / 200 * model::diagonal(problem.target);
  const double threshold = rms / (std::sqrt(vertices) * model::total_length(problem.structure));
  StageResult few =
      sparsify::remove_greedily(pulling.network, problem.target, {.threshold = threshold}, control);
  std::ranges::move(few.trace, std::back_inserter(result.trace));
  if (!few.valid()) return {};
  result.network = rebased(std::move(few.network), network::stiff_rest_ratio);
  return {{.network = result.network}};
}

// Whether one of the networks is as near as an elimination can mend.
bool any_near(std::span<const Start> starts, const Problem& problem,
              const EliminationOptions& options) {
  const double percent = options.start.mendable *
                         std::max(options.goal.max_error_percent, options.start.max_error_percent);
  return std::ranges::any_of(starts, [&](const Start& start) {
    return sensitivity::deviation(problem.target, start.network.state).max_percent <= percent;
  });
}

}  // namespace

Starts starts_of(const Problem& problem, const EliminationOptions& options,
                 const network::Control& control, StageResult& result) {
  // Eliminations of the whole take long and end early when there are many rods.
  const bool whole_only = problem.symmetry || options.goal.every_number;
  const int rods = whole_only ? 1 : static_cast<int>(problem.structure.rods.size());
  Starts starts{.many_rods = rods >= options.block.many_rods};
  if (rods >= options.block.some_rods)
    starts.near = balanced_starts(among_neighbours_only(problem), options, control, result);
  starts.full = starts.near;
  if (!starts.many_rods || starts.near.empty())
    starts.full = balanced_starts(problem, options, control, result);
  if (starts.many_rods) {
    for (Start& start : starts.full) start.descents = 1;
    return starts;
  }
  starts.symmetries = symmetry_seeds(problem, options.start);
  std::vector<const symmetry::Group*> groups;
  if (problem.symmetry) groups.push_back(problem.group());
  for (const auto& seed : starts.symmetries) groups.push_back(&seed);
  const int max_cables = std::max(
      {options.start.min_beam_cables, options.goal.cables, cable_count(result.network) / 2});
  starts.few = symmetric_starts(problem, groups, max_cables, options, control, starts.counts);
  // Removing single springs keeps no symmetry, nor cables that are given.
  const bool springs = !problem.symmetry && problem.structure.cables.empty();
  if (springs && !any_near(starts.full, problem, options) &&
      !any_near(starts.few, problem, options))
    if (auto sprung = sprung_starts(problem, options, control, result);
        any_near(sprung, problem, options))
      starts.full = std::move(sprung);
  return starts;
}

}  // namespace tencer::elimination
