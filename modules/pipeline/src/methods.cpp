#include "methods.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <tencer/core/words.hpp>
#include <tencer/elimination/eliminate.hpp>
#include <tencer/elimination/search.hpp>
#include <tencer/ground_structure/dense_springs.hpp>
#include <tencer/ground_structure/pin_cables.hpp>
#include <tencer/sparsify/greedy.hpp>
#include <tencer/sparsify/slide.hpp>
#include <tencer/sparsify/sparsify.hpp>
#include <thread>
#include <utility>

#include "edit.hpp"
#include "snapshots.hpp"

namespace tencer::pipeline {
namespace {

using elimination::EliminationOptions;
using elimination::EliminationResult;
using elimination::Solution;
using ground_structure::Problem;
using network::Network;
using network::StageResult;

int threads_of(const model::DesignSettings& settings) {
  const auto has = static_cast<int>(std::thread::hardware_concurrency());  // 0: not known
  return settings.threads.value_or(std::max(has, 1));
}

// What a search of little or much effort does less or more of than the usual one.
void set_effort(int effort, EliminationOptions& options) {
  if (effort == 1) {
    options.local_search.max_rounds = 0;
    for (auto& balance : options.start.balances) balance.descents = 2;
    options.fit.further = 1;
  }
  if (effort == 3) {
    options.local_search.max_rounds = 60;
    options.local_search.patience = 6;
    options.fit.further = 4;
    options.prolong.spare = 4;
  }
}

// The stages of a design one after the other, each from the network of the last; they end early
// when one is interrupted, or leaves no cables: the rods then rest without.
class Stages {
 public:
  Stages(const Task& task, bool every_number, const RunOptions& options)
      : settings_(task.scene.design),
        task_(task),
        problem_(task.prepared.problem),
        every_number_(every_number),
        options_(options),
        control_{.stop = options.stop, .progress = options.progress} {
    result_.network = problem_.bare();
  }

  // The paper's own route (section 5).
  void dense_springs() {
    const auto& target = problem_.target;
    const auto& backend = *task_.backend;
    const sparsify::OuterOptions outer{.second_derivatives = settings_.hessian};
    result_.network.structure.cables = ground_structure::dense_springs(
        problem_.structure, target.points, problem_.candidates, settings_.spring_stiffness);
    add(sparsify::prune(result_.network, target, {}, control_));
    if (goes_on())
      add(sparsify::remove_greedily(result_.network, target,
                                    {.threshold = settings_.greedy_threshold}, control_));
    if (goes_on())
      add(sparsify::sparsify(result_.network, target, backend,
                             {.max_error_percent = settings_.max_error,
                              .weights = settings_.sparsity_weights,
                              .max_cable_length = problem_.rules.max_cable_length,
                              .outer = outer},
                             control_));
    if (goes_on())
      add(sparsify::slide(result_.network, target, problem_.rules, backend, outer, control_));
    if (goes_on())
      add(elimination::eliminate(result_.network, problem_, first_options(), control_));
  }

  void force_balance() {
    if (const auto& edit = task_.scene.edit) {
      add(elimination::revise(revision_of(*edit, task_.prepared.scaling), problem_, first_options(),
                              control_));
      return;
    }
    add(elimination::search(problem_, first_options(), control_));
  }

  // Pins to cables to the anchors, and of the cables there are then fewer.
  void hand_over() {
    if (result_.interrupted) return;
    // Few cables may leave so much to the pins that it is more than cables can take over: then from
    // a network with more.
    std::vector<Network> pinned{result_.network};
    for (Solution& solution : solutions_)
      if (solution.cables() > cable_count(result_.network))
        pinned.push_back(std::move(solution.network));
    solutions_.clear();
    StageResult handed;
    for (const Network& one : pinned) {
      handed = replace_pins(one, problem_, control_);
      if (handed.valid() && handed.trace.back().max_percent <= settings_.max_error) break;
    }
    add(std::move(handed));
    if (goes_on())
      add(elimination::eliminate(result_.network, *task_.released,
                                 elimination_options(settings_.cables.value_or(0), every_number_),
                                 control_));
  }

  Outcome outcome() {
    thin_snapshots(trace_);
    unscale_snapshots(trace_, task_.prepared.scaling);
    Outcome outcome{.trace = std::move(trace_), .interrupted = result_.interrupted};
    for (Solution& solution : solutions_) outcome.networks.push_back(std::move(solution.network));
    const int asked = cable_count(result_.network);
    const auto at = std::ranges::find_if(
        outcome.networks, [&](const Network& network) { return cable_count(network) >= asked; });
    outcome.asked = static_cast<int>(at - outcome.networks.begin());
    if (at == outcome.networks.end()) outcome.networks.push_back(std::move(result_.network));
    return outcome;
  }

 private:
  bool goes_on() const { return !result_.interrupted && !result_.network.structure.cables.empty(); }

  void add(StageResult next) {
    for (const auto& row : next.trace) {
      std::ostringstream line;
      line << std::setprecision(3) << row.stage << ": " << core::counted(row.cables, "cable")
           << ", max error " << row.max_percent << " %, " << row.seconds << " s"
           << (row.note.empty() ? "" : "; ") << row.note;
      if (options_.log) options_.log(core::Level::debug, line.str());
      trace_.push_back(row);
    }
    result_ = std::move(next);
  }

  void add(EliminationResult next) {
    solutions_ = std::move(next.solutions);
    add(std::move(next.stage));
  }

  // In scaled units.
  elimination::Workmanship workmanship() const {
    const model::BuildSettings& build = task_.scene.build;
    const double length = task_.prepared.scaling.scale.length;
    const std::string& unit = task_.scene.length_unit;
    const double size = length * model::diagonal(problem_.target);
    const auto allowed = build.max_deviation.value_or(model::Allowance{settings_.max_error});
    return {.length_error = build.length_error_in(unit) / length,
            .attachment_error = build.attachment_error_in(unit) / length,
            .max_deviation = allowed.length(unit, size) / length,
            .min_tension_ratio = build.min_tension_ratio,
            .min_tension = build.min_tension.value_or(0.0) / task_.prepared.scaling.scale.force()};
  }

  EliminationOptions elimination_options(int cables, bool every_number) const {
    EliminationOptions options{.goal = {.max_error_percent = settings_.max_error,
                                        .cables = cables,
                                        .every_number = every_number},
                               .measure = settings_.objective,
                               .workmanship = workmanship(),
                               .threads = threads_of(settings_)};
    set_effort(settings_.effort, options);
    options.fit.optimizer = task_.fit_optimizer();
    if (settings_.hessian == model::SecondDerivatives::limited_memory)
      options.fit.second_derivatives = settings_.hessian;  // there are no exact ones for this fit
    return options;
  }

  // Before pins are handed over, all numbers of cables are of use, and there must be room for the
  // cables that come to these.
  EliminationOptions first_options() const {
    const auto pins = static_cast<int>(problem_.structure.pins.size());
    const int further = settings_.hand_over ? pins * (problem_.structure.planar ? 2 : 3) : 0;
    const int cables = settings_.cables ? std::max(1, *settings_.cables - further) : 0;
    return elimination_options(cables, every_number_ || settings_.hand_over);
  }

  const model::DesignSettings& settings_;
  const Task& task_;
  const Problem& problem_;
  bool every_number_;
  const RunOptions& options_;
  network::Control control_;
  StageResult result_{};
  std::vector<Solution> solutions_{};
  std::vector<model::StageRow> trace_{};
};

}  // namespace

Outcome run_method(const Task& task, bool every_number, const RunOptions& options) {
  Stages stages(task, every_number, options);
  if (task.scene.design.method == model::Method::dense_springs)
    stages.dense_springs();
  else
    stages.force_balance();
  if (task.scene.design.hand_over) stages.hand_over();
  return stages.outcome();
}

}  // namespace tencer::pipeline
