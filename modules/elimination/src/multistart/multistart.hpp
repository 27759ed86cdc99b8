// The search for few cables on rods of one resolution: backward eliminations from several networks,
// each in several ways, and variations of what they find.
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <tencer/ground_structure/problem.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <utility>

#include "moves/backward_elimination.hpp"
#include "multistart/pareto_archive.hpp"

namespace tencer::elimination {

// Where backward eliminations begin: with the first `descents` settings of the portfolio. symmetry:
// null, or a group that the network has and its eliminations keep.
struct Start {
  network::Network network{};
  int descents = 6;
  const symmetry::Group* symmetry = nullptr;
};

// Whether a network is fitted although the search was stopped.
enum class Fit { unless_stopped, always };

// No network much softer than `start` is entered, nor one that errors move much further than it and
// than is asked, nor one whose rods are more free of each other.
Requirements requirements_for(const network::Network& start, const model::Target& target,
                              const model::Rules& rules, const symmetry::Group* symmetry,
                              const EliminationOptions& options);

// Refers to all that it is given. Its functions are called by one thread, and share the work among
// options.threads; results do not depend on their number.
class Multistart {
 public:
  Multistart(const Requirements& requirements, std::span<const springs::Cable> candidates,
             const EliminationOptions& options, const network::Control& control,
             const network::StageRecorder& recorder);

  // Backward eliminations from each start; of each the networks that may answer the goal, fitted.
  ParetoArchive eliminate_from(std::span<const Start> starts);
  // Of the eliminations since the last call the way of the best: networks with ever fewer cables.
  std::vector<network::Network> take_way() { return std::exchange(best_way_, {}).networks; }

  // Varies the best network of each archive, round by round, until options.local_search.patience
  // rounds (or fewer when given) bring nothing better in any, and calls record() after each. The
  // archives are kept apart so that one good network does not displace the others.
  void iterated_local_search(std::span<ParetoArchive> archives, int patience,
                             const std::function<void()>& record);

  // The network fitted as closely as it goes, or as it is when there is no time left; adds nothing
  // when there is no stable equilibrium near it.
  void add_fitted(const network::Network& network, ParetoArchive& archive,
                  Fit fit = Fit::unless_stopped);

  // What was done since the last call.
  network::SolveCounts take_counts();

  // For those who work beside it, from any thread.
  FittedNetwork fitted(const network::Network& network, const Requirements& requirements,
                       const Objective& objective = {}) const;
  Descent descent(const DescentSettings& settings, double max_error_percent) const;
  void count(const FittedNetwork& fitted);
  void report(const FittedNetwork& fitted) const;

  const Requirements& requirements() const { return requirements_; }
  const EliminationOptions& options() const { return options_; }
  double diagonal() const { return diagonal_; }  // of the target
  // The largest distance that eliminations aim at.
  double aim_percent() const;

 private:
  // Adds networks like the archives' best but for a cable more and others less, in several ways;
  // what is tried differs from round to round. false: there is nothing to vary.
  bool perturb(std::span<ParetoArchive> archives, int round);
  bool insert(FittedNetwork& at, const Solution& solution, int insertion) const;
  // insertion: which of the best cables goes in; -1: none.
  ParetoArchive perturbed(const Solution& solution, const DescentSettings& settings, int insertion);
  void look_for_footing(std::vector<Solution>& found) const;
  ParetoArchive fit_answers(const std::vector<network::Network>& path);

  struct Way {
    std::vector<network::Network> networks{};
    std::optional<model::Score> found{};  // at its end; none: nothing
  };
  void keep_better(Way& way);

  const Requirements& requirements_;
  std::span<const springs::Cable> candidates_;
  const EliminationOptions& options_;
  const network::Control& control_;
  const network::StageRecorder& recorder_;
  double diagonal_;
  std::mutex mutex_;  // of the counts
  network::SolveCounts counts_;
  Way best_way_;
};

// The archive's best network, and a row for what was done since the last.
void record(const ParetoArchive& archive, Multistart& multistart, const model::Target& target,
            network::StageRecorder& recorder, network::StageResult& result);

}  // namespace tencer::elimination
