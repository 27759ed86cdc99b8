#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <tencer/elimination/revise.hpp>
#include <tencer/elimination/search.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <utility>

#include "moves/replacement.hpp"
#include "multilevel/canonical.hpp"
#include "multilevel/coarsen.hpp"
#include "multilevel/transfer.hpp"
#include "multistart/block_elimination.hpp"
#include "multistart/starts.hpp"
#include "state/standing.hpp"

namespace tencer::elimination {
namespace {

using ground_structure::Problem;
using network::Network;
using network::StageResult;

struct Found {
  ParetoArchive archive{};
  std::optional<Requirements> requirements{};  // that the networks kept; none: nothing was tried
};

// All of the search on rods of one resolution; its rows and its best network go to `result`.
Found search_on(const Problem& problem, const EliminationOptions& options,
                const network::Control& control, StageResult& result) {
  Starts starts = starts_of(problem, options, control, result);
  if (starts.empty()) return {};
  network::StageRecorder recorder("eliminate", control);
  recorder.add(starts.counts);
  Found found{.requirements = requirements_for(starts.first(), problem.target, problem.rules,
                                               problem.group(), options)};
  Multistart multistart(*found.requirements, problem.candidates, options, control, recorder);
  for (Start& start : starts.near)
    start = {.network = eliminate_in_blocks(multistart, start.network), .descents = 2};
  std::ranges::move(starts.near, std::back_inserter(starts.few));

  ParetoArchive archives[] = {multistart.eliminate_from(starts.full),
                              multistart.eliminate_from(starts.few)};
  const auto record_both = [&] {
    for (const ParetoArchive& archive : archives) found.archive.add(archive);
    record(found.archive, multistart, problem.target, recorder, result);
  };
  record_both();
  multistart.iterated_local_search(archives, starts.many_rods ? 1 : options.local_search.patience,
                                   record_both);
  return found;
}

// The network where it comes to rest, or as it is when it does not.
Network at_rest(Network network, const network::Control& control) {
  auto solved = equilibrium::solve(equilibrium::System(network.structure), network.state,
                                   {.stop = control.stop});
  if (solved.usable()) network.state = std::move(solved.state);
  return network;
}

// The same for another problem.
Requirements carried_over(const Requirements& requirements, const Problem& problem) {
  return {.target = problem.target,
          .rules = problem.rules,
          .symmetry = problem.group(),
          .min_eigenvalue = requirements.min_eigenvalue,
          .max_floating = requirements.max_floating,
          .fixed_cables = requirements.fixed_cables,
          .workmanship = requirements.workmanship,
          .standing_deviation = requirements.standing_deviation};
}

// The revision's network, at rest, without the cables that go; some may be new in it.
Network replaced(const Revision& revision, const Problem& problem, Network network,
                 const Multistart& multistart) {
  if (revision.going == 0) return network;
  const EliminationOptions& options = multistart.options();
  Problem with_all = problem;
  with_all.rules.unwanted.clear();
  const Requirements requirements = carried_over(multistart.requirements(), with_all);
  FittedNetwork at =
      multistart.fitted(network, requirements,
                        {.norm = {.unit = multistart.aim_percent() / 100 * multistart.diagonal()},
                         .stability_weight = options.portfolio.front().stability_weight});
  if (at.usable() && replace(at, revision.kept, revision.going, problem.candidates,
                             options.local_search, options.removal))
    return at.network();
  auto& cables = network.structure.cables;
  const auto first = cables.begin() + revision.kept;
  cables.erase(first, first + revision.going);
  return network;
}

// From a network of the problem's own rods: fitted, thinned, and varied for a while.
Found revise_on(const Revision& revision, const Problem& problem, const EliminationOptions& options,
                const network::Control& control, StageResult& result) {
  constexpr int descents = 2;
  constexpr double roomier = 2;  // few cables move more by errors than those of a balance
  network::StageRecorder recorder("revise", control);
  Start start{.network = at_rest(revision.network, control), .descents = descents};
  Found found{.requirements = requirements_for(start.network, problem.target, problem.rules,
                                               problem.group(), options)};
  found.requirements->fixed_cables = revision.kept;
  found.requirements->workmanship.max_deviation *= roomier;
  Multistart multistart(*found.requirements, problem.candidates, options, control, recorder);
  start.network = replaced(revision, problem, std::move(start.network), multistart);
  found.archive = multistart.eliminate_from({&start, 1});
  const auto record_it = [&] {
    record(found.archive, multistart, problem.target, recorder, result);
  };
  record_it();
  const Solution* best = found.archive.best_for(options.goal);
  const bool met = best && options.goal.met(best->score());
  multistart.iterated_local_search({&found.archive, 1}, met ? 1 : options.local_search.patience,
                                   record_it);
  return found;
}

Found find(const Revision* revision, const Problem& problem, const EliminationOptions& options,
           const network::Control& control, StageResult& result) {
  return revision ? revise_on(*revision, problem, options, control, result)
                  : search_on(problem, options, control, result);
}

// The best of the networks found on fewer vertices that stands on the rods as they are, when there
// is no time for more.
void prolong_best(const ParetoArchive& coarse, const model::Structure& bare, Multistart& multistart,
                  ParetoArchive& archive) {
  const model::Goal& goal = multistart.options().goal;
  const Solution* best = coarse.best_for(goal);
  if (!best) return;
  multistart.add_fitted(transferred(best->network, bare), archive, Fit::always);
  // Those of more cables hold more firmly.
  const std::vector<Solution> solutions = coarse.best();
  for (auto next = solutions.begin(); next != solutions.end() && !archive.best_for(goal); ++next)
    if (next->cables() > best->cables())
      multistart.add_fitted(transferred(next->network, bare), archive, Fit::always);
}

// Networks found on fewer vertices brought to the rods as they are, until one answers the goal, and
// a few more. While none stands those with more cables follow, ever more of them left out.
void prolong(const ParetoArchive& coarse, const model::Structure& bare, Multistart& multistart,
             ParetoArchive& archive) {
  const EliminationOptions& options = multistart.options();
  const model::Goal& goal = options.goal;
  model::Goal loose = goal;
  loose.max_error_percent *= options.prolong.fits_closer;
  const std::vector<Solution> solutions = coarse.best();
  std::vector<const Solution*> order;
  for (const Solution& solution : solutions)
    if (goal.every_number || loose.met(solution.score())) order.push_back(&solution);
  if (goal.by_number()) std::ranges::reverse(order);
  int spare = 0;
  std::size_t step = 1;
  for (std::size_t i = 0; i < order.size(); i += step) {
    const Solution* best = archive.best_for(goal);
    if (best && !goal.every_number && (goal.by_number() || goal.met(best->score())) &&
        ++spare > (best->standing.stands() ? 1 : 2) * options.prolong.spare) {
      if (goal.by_number() || best->standing.stands()) return;
      step *= 2;
    }
    multistart.add_fitted(transferred(order[i]->network, bare), archive);
  }
}

int vertices_of(const model::Structure& structure) {
  int vertices = 0;
  for (const auto& rod : structure.rods) vertices += rod.vertices();
  return vertices;
}

// The search on fewer vertices, and what it found brought back to all; an empty archive when
// nothing came of it.
ParetoArchive find_coarse(const Revision* revision, const Problem& problem, const Problem& coarse,
                          const EliminationOptions& options, const network::Control& control,
                          StageResult& result) {
  EliminationOptions coarse_options = options;
  coarse_options.fit.optimizer.reset();
  coarse_options.workmanship = rounded(options.workmanship);
  std::optional<Revision> coarse_revision;
  if (revision)
    coarse_revision = {transferred(revision->network, coarse.structure), revision->kept,
                       revision->going};
  const Found found =
      find(revision ? &*coarse_revision : nullptr, coarse, coarse_options, control, result);
  const int vertices = vertices_of(coarse.structure);
  if (vertices < vertices_of(problem.structure))
    for (auto& row : result.trace)
      row.note += (row.note.empty() ? "" : "; ") + std::string("on ") + std::to_string(vertices) +
                  " vertices";
  if (!found.requirements) return {};
  network::StageRecorder recorder("fit", control);
  const Requirements requirements = carried_over(*found.requirements, problem);
  Multistart multistart(requirements, problem.candidates, options, control, recorder);
  ParetoArchive archive;
  if (recorder.stopped())
    prolong_best(found.archive, problem.structure, multistart, archive);
  else
    prolong(found.archive, problem.structure, multistart, archive);
  const auto record_it = [&] { record(archive, multistart, problem.target, recorder, result); };
  if (const Solution* best = archive.best_for(options.goal)) {
    record_it();
    // What was lost on the way may be found again.
    const Solution* before = found.archive.best_for(options.goal);
    if (!best->standing.stands() ||
        (before && options.goal.improves(before->score(), best->score())))
      multistart.iterated_local_search({&archive, 1}, 1, record_it);
  }
  return archive;
}

// On fewer vertices first, where that saves time; on all when nothing comes of it.
ParetoArchive find_anywhere(const Revision* revision, const Problem& problem,
                            const EliminationOptions& options, const network::Control& control,
                            StageResult& result) {
  if (const auto coarse = coarsened(problem, options.coarse)) {
    ParetoArchive archive = find_coarse(revision, problem, *coarse, options, control, result);
    if (archive.best_for(options.goal)) return archive;
  }
  // What is on fewer vertices is of no use.
  result.network = revision ? revision->network : problem.bare();
  return find(revision, problem, options, control, result).archive;
}

// What was asked for, standing.
bool answered(const ParetoArchive& archive, const model::Goal& goal) {
  const Solution* best = archive.best_for(goal);
  return best && goal.met(best->score()) && best->standing.stands();
}

// The box about a target that was turned has another diagonal: `percent` of it are 1 % of the one
// that was given.
network::Control with_percent(const network::Control& control, double percent) {
  network::Control turned = control;
  turned.progress = network::ProgressSink([&control, percent](network::Progress at) {
    at.max_percent /= percent;
    control.progress(at);
  });
  return turned;
}

EliminationResult found_for(const Problem& given, const Revision* revision,
                            EliminationOptions options, const network::Control& given_control) {
  options.validate();
  validate(given.rules, given.structure);
  const Canonical canonical(given);
  const Problem& problem = canonical.problem();
  const double percent = model::diagonal(given.target) / model::diagonal(problem.target);
  options.goal.max_error_percent = rounded(percent * options.goal.max_error_percent);
  const network::Control control = with_percent(given_control, percent);
  std::optional<Revision> own;
  if (revision) {
    own = {canonical.counted(transferred(revision->network, given.structure)), revision->kept,
           revision->going};
    revision = &*own;
  }
  StageResult result{.network = revision ? revision->network : problem.bare()};
  ParetoArchive archive = find_anywhere(revision, problem, options, control, result);
  network::StageRecorder recorder("eliminate", control);
  const model::Goal& goal = options.goal;
  if (goal.by_number() && !goal.every_number && !answered(archive, goal) && !recorder.stopped()) {
    // Where the closest with so many cables does not stand, the fewest within the error may.
    EliminationOptions by_error = options;
    by_error.goal.cables = 0;
    archive.add(find_anywhere(revision, problem, by_error, control, result));
    if (const Solution* best = archive.best_for(goal)) result.network = best->network;
  }
  recorder.finish(result, problem.target);
  result.network = canonical.restored(result.network, given.structure);
  std::vector<Solution> solutions = archive.best();
  for (Solution& solution : solutions) {
    solution.network = canonical.restored(solution.network, given.structure);
    solution.max_percent /= percent;
    solution.rms_percent /= percent;
  }
  for (auto& row : result.trace) {
    row.max_percent /= percent;
    row.rms_percent /= percent;
    for (model::Snapshot& snapshot : row.snapshots) {
      canonical.restore(snapshot);
      snapshot.max_percent /= percent;
    }
  }
  return {.stage = std::move(result), .solutions = std::move(solutions)};
}

}  // namespace

EliminationResult search(const Problem& problem, const EliminationOptions& options,
                         const network::Control& control) {
  return found_for(problem, nullptr, options, control);
}

EliminationResult revise(const Revision& revision, const Problem& problem,
                         const EliminationOptions& options, const network::Control& control) {
  return found_for(problem, &revision, options, control);
}

}  // namespace tencer::elimination
