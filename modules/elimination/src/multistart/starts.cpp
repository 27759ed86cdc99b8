#include "multistart/starts.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <tencer/ground_structure/beam_search.hpp>
#include <tencer/ground_structure/force_balance.hpp>
#include <tencer/ground_structure/neighbours.hpp>
#include <tencer/ground_structure/problem_symmetry.hpp>
#include <tencer/network/parallel.hpp>
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

}  // namespace

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

std::vector<symmetry::Group> symmetry_seeds(const Problem& problem, const StartOptions& options) {
  if (problem.symmetry || options.max_seed_order == 0) return {};
  return symmetry::subgroups(ground_structure::detected(problem, options.nearly_symmetric).group,
                             options.max_seed_order);
}

Problem among_neighbours_only(Problem problem) {
  if (!problem.rules.pairs)
    problem.candidates =
        ground_structure::among_neighbours(problem.candidates, problem.target.points);
  return problem;
}

}  // namespace tencer::elimination
