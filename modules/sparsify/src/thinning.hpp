// The search for few cables on rods of one resolution: descents, and variations of what they find.
#pragma once

#include <functional>
#include <mutex>
#include <span>

#include "descent.hpp"
#include "part.hpp"
#include "pool.hpp"
#include "removal.hpp"
#include "stage_clock.hpp"

namespace tencer::sparsify {

// Ways to descend that there are.
inline constexpr int temper_count = 6;

// Where descents begin, at most so many, each of its own temper. symmetry: null, or a group that
// the network has and its descents keep.
struct Start {
  Network network{};
  int descents = 6;
  const symmetry::Group* symmetry = nullptr;
};

// Nothing much softer than `start` is entered, nor anything whose rods are more free of each other.
Task task_for(const Network& start, const sensitivity::Target& target, const Rules& rules,
              const symmetry::Group* symmetry, const ThinOptions& options);

class Thinning {
 public:
  // Refers to everything.
  Thinning(const Task& task, std::span<const springs::Cable> candidates, const ThinOptions& options,
           const Control& control, const StageClock& clock);

  // Descents from each start, and of each the networks that answer what is asked.
  Pool descend_from(std::span<const Start> starts);

  // The network with fewer cables: they are taken out of pairs of rods, one pair after the other,
  // while the other rods are held. For many rods, where descents of the whole take long and end
  // early. As it is when it is not in stable equilibrium.
  Network by_parts(const Network& start);

  // Varies the best network of each island, round by round, until `patience` rounds bring nothing
  // better on any, and calls record() after each.
  void improve(std::span<Pool> islands, int patience, const std::function<void()>& record);

  // The network fitted as closely as it goes, or as it is when there is no time left; adds nothing
  // when there is no stable equilibrium near it.
  void add_fitted(const Network& network, Pool& pool);

  // What was done since the last call.
  Effort take_effort();

 private:
  // Adds networks like the islands' best but for a cable more and others less, in several ways;
  // what is tried differs from round to round.
  void vary(std::span<Pool> islands, int round);

  std::vector<const Choice*> bests(std::span<const Pool> islands) const;
  // false: takes nothing out.
  bool thin_part(Walker& whole, const Part& part);
  // The largest distance that descents aim at.
  double steered_percent() const;
  DescentOptions descent(int temper, double percent);
  Pool choose(const std::vector<Network>& path);
  // offer: which of the best cables goes in; -1: none.
  Pool varied(const Choice& choice, int temper, int offer);
  void count(const Walker& walker);
  void report(const Walker& walker);

  const Task& task_;
  std::span<const springs::Cable> candidates_;
  const ThinOptions& options_;
  const Control& control_;
  const StageClock& clock_;
  double diagonal_;
  std::mutex mutex_;
  Effort effort_;
};

}  // namespace tencer::sparsify
