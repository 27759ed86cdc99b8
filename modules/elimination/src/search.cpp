#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <tencer/elimination/search.hpp>
#include <tencer/ground_structure/beam_search.hpp>
#include <tencer/ground_structure/force_balance.hpp>
#include <tencer/ground_structure/neighbours.hpp>
#include <tencer/network/parallel.hpp>
#include <utility>

#include "multilevel/coarsen.hpp"
#include "multilevel/transfer.hpp"
#include "multistart/block_elimination.hpp"
#include "state/standing.hpp"

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

// Networks that balance the forces to parts of the error that is accepted. The first row and
// network of `result` are of the first that is valid; failing all, of the first.
std::vector<Start> balanced_starts(const Problem& problem, const EliminationOptions& options,
                                   const network::Control& control, StageResult& result) {
  const auto& balances = options.start.balances;
  std::vector<StageResult> outcomes(balances.size());
  const network::StageRecorder recorder("balance", control);
  network::in_parallel(static_cast<int>(outcomes.size()), options.threads, [&](int i) {
    outcomes[i] =
        force_balance(problem, problem.group(),
                      {.max_error_percent = balance_percent(options, balances[i].part)}, control);
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
      problem, &group, {.max_error_percent = balance_percent(options, part)}, control);
  for (const model::StageRow& row : outcome.trace)
    counts += {.solves = row.solves, .iterations = row.iterations};
  if (outcome.valid())
    starts.push_back({.network = std::move(outcome.network), .descents = 2, .symmetry = &group});
  return starts;
}

// The same for every group, side by side.
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

// The problem without cables between rods that are no neighbours, unless the rules say which rods
// to join.
Problem among_neighbours_only(Problem problem) {
  if (!problem.rules.pairs)
    problem.candidates =
        ground_structure::among_neighbours(problem.candidates, problem.target.points);
  return problem;
}

struct Found {
  ParetoArchive archive{};
  // What the networks were required to keep.
  double min_eigenvalue = 0.0;
  int max_floating = 1;
  Workmanship workmanship{};
  double standing_deviation = 0.0;
};

// All of the search on rods of one resolution; its rows and its best network go to `result`.
Found search_on(const Problem& problem, std::span<const symmetry::Group> seeds,
                const EliminationOptions& options, const network::Control& control,
                StageResult& result) {
  // Eliminations of the whole take long and end early when there are many rods.
  const bool whole_only = problem.symmetry || options.goal.every_number;
  const int rods = whole_only ? 1 : static_cast<int>(problem.structure.rods.size());
  const bool many = rods >= options.block.many_rods;
  std::vector<Start> near;
  if (rods >= options.block.some_rods)
    near = balanced_starts(among_neighbours_only(problem), options, control, result);
  std::vector<Start> full = near;
  if (!many || near.empty()) full = balanced_starts(problem, options, control, result);
  if (full.empty() || result.interrupted) return {};

  network::StageRecorder recorder("eliminate", control);
  Requirements requirements = requirements_for(full.front().network, problem.target, problem.rules,
                                               problem.group(), options);
  // Where errors move even the many cables of a balance further than is asked, so they do fewer.
  if (error_deviation(full.front().network, options.workmanship) >
      options.workmanship.max_deviation)
    requirements.standing_deviation = requirements.workmanship.max_deviation;
  Multistart multistart(requirements, problem.candidates, options, control, recorder);
  for (Start& start : near)
    start = {.network = eliminate_in_blocks(multistart, start.network), .descents = 2};
  if (many)
    for (Start& start : full) start.descents = 1;
  std::vector<Start> few;
  if (!many) {
    std::vector<const symmetry::Group*> groups;
    if (problem.symmetry)
      groups.push_back(problem.group());
    else
      for (const auto& seed : seeds) groups.push_back(&seed);
    const int max_cables = std::max(
        {options.start.min_beam_cables, options.goal.cables, cable_count(result.network) / 2});
    network::SolveCounts counts;
    few = symmetric_starts(problem, groups, max_cables, options, control, counts);
    recorder.add(counts);
  }
  std::ranges::move(near, std::back_inserter(few));

  Found found{.min_eigenvalue = requirements.min_eigenvalue,
              .max_floating = requirements.max_floating,
              .workmanship = requirements.workmanship,
              .standing_deviation = requirements.standing_deviation};
  ParetoArchive archives[] = {multistart.eliminate_from(full), multistart.eliminate_from(few)};
  const auto record = [&] {
    for (const ParetoArchive& archive : archives) found.archive.add(archive);
    if (const Solution* best = found.archive.best_for(options.goal)) result.network = best->network;
    recorder.add(multistart.take_counts());
    result.trace.push_back(recorder.row(result.network, problem.target));
  };
  record();
  multistart.iterated_local_search(archives, many ? 1 : options.local_search.patience, record);
  return found;
}

// Networks found on fewer vertices brought to the rods as they are, until one answers the goal, and
// a few more.
void prolong(const std::vector<Solution>& coarse, const model::Structure& bare,
             Multistart& multistart, ParetoArchive& archive) {
  const EliminationOptions& options = multistart.options();
  const model::Goal& goal = options.goal;
  model::Goal loose = goal;
  loose.max_error_percent *= options.prolong.fits_closer;
  std::vector<const Solution*> order;
  for (const Solution& solution : coarse)
    if (goal.every_number || loose.met(solution.score())) order.push_back(&solution);
  if (goal.by_number()) std::ranges::reverse(order);
  int spare = 0;
  for (const Solution* solution : order) {
    const Solution* best = archive.best_for(goal);
    if (best && !goal.every_number && (goal.by_number() || goal.met(best->score())) &&
        ++spare > (best->standing.stands() ? 1 : 2) * options.prolong.spare)
      return;
    multistart.add_fitted(transferred(solution->network, bare), archive);
  }
}

int vertices_of(const model::Structure& structure) {
  int vertices = 0;
  for (const auto& rod : structure.rods) vertices += rod.vertices();
  return vertices;
}

// The search on fewer vertices, and what it found brought back to all; an empty archive when
// nothing came of it.
ParetoArchive search_coarse(const Problem& problem, const Problem& coarse,
                            std::span<const symmetry::Group> seeds,
                            const EliminationOptions& options, const network::Control& control,
                            StageResult& result) {
  std::vector<symmetry::Group> coarse_seeds;
  for (const auto& seed : seeds)
    coarse_seeds.push_back(transferred(seed, problem.structure.rods, coarse.structure.rods));
  EliminationOptions own_fit = options;
  own_fit.fit.optimizer.reset();
  const Found found = search_on(coarse, coarse_seeds, own_fit, control, result);
  for (auto& row : result.trace)
    row.note += (row.note.empty() ? "" : "; ") + std::string("on ") +
                std::to_string(vertices_of(coarse.structure)) + " vertices";
  network::StageRecorder recorder("fit", control);
  const Requirements requirements{.target = problem.target,
                                  .rules = problem.rules,
                                  .symmetry = problem.group(),
                                  .min_eigenvalue = found.min_eigenvalue,
                                  .max_floating = found.max_floating,
                                  .workmanship = found.workmanship,
                                  .standing_deviation = found.standing_deviation};
  Multistart multistart(requirements, problem.candidates, options, control, recorder);
  ParetoArchive archive;
  prolong(found.archive.best(), problem.structure, multistart, archive);
  const auto record = [&] {
    result.network = archive.best_for(options.goal)->network;
    recorder.add(multistart.take_counts());
    result.trace.push_back(recorder.row(result.network, problem.target));
  };
  if (const Solution* best = archive.best_for(options.goal)) {
    record();
    // What was lost on the way may be found again.
    const Solution* before = found.archive.best_for(options.goal);
    if (!best->standing.stands() ||
        (before && options.goal.improves(before->score(), best->score())))
      multistart.iterated_local_search({&archive, 1}, 1, record);
  }
  return archive;
}

}  // namespace

EliminationResult search(const Problem& problem, std::span<const symmetry::Group> symmetry_seeds,
                         const EliminationOptions& options, const network::Control& control) {
  options.validate();
  validate(problem.rules, problem.structure);
  StageResult result{.network = problem.bare()};
  ParetoArchive archive;
  if (const auto coarse = coarsened(problem, options.coarse))
    archive = search_coarse(problem, *coarse, symmetry_seeds, options, control, result);
  if (!archive.best_for(options.goal))
    archive = search_on(problem, symmetry_seeds, options, control, result).archive;
  network::StageRecorder recorder("eliminate", control);
  recorder.finish(result, problem.target);
  return {.stage = std::move(result), .solutions = archive.best()};
}

}  // namespace tencer::elimination
