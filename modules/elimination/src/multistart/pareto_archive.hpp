// The networks found so far: of each number of cables the closest to the target, of any footing and
// of a good one; and the one that errors move least.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <tencer/elimination/solution.hpp>
#include <vector>

namespace tencer::elimination {

class ParetoArchive {
 public:
  void add(const Solution& solution);
  void add(const ParetoArchive& other);

  // What the goal asks for, or what comes nearest to it; null when there is nothing. A solution of
  // a better footing comes before others when Goal::prefers_footing says so.
  const Solution* best_for(const model::Goal& goal) const;

  // What to go on from: best_for() the goal when that stands; else of those that keep their pose
  // the one that errors move least, if there is one.
  const Solution* base_for(const model::Goal& goal) const;

  // The fewest cables first, each closer to the target than all with fewer cables, or the first of
  // its footing. Of those with as many cables the one of the best footing.
  std::vector<Solution> best() const;

 private:
  using ByCables = std::map<int, Solution>;

  // By footing: what has at least that one.
  std::array<ByCables, 3> closest_{};
  std::optional<Solution> least_moved_{};  // of those that keep their pose
};

}  // namespace tencer::elimination
