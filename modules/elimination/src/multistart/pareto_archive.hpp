// The networks found so far: of each number of cables the closest to the target, and the closest
// that stands as it is built.
#pragma once

#include <map>
#include <tencer/elimination/solution.hpp>
#include <vector>

namespace tencer::elimination {

class ParetoArchive {
 public:
  void add(Solution solution);
  void add(const ParetoArchive& other);

  // What the goal asks for, or what comes nearest to it; null when there is nothing. A solution
  // that stands comes before all that do not when Goal::prefers_standing says so.
  const Solution* best_for(const model::Goal& goal) const;

  // The fewest cables first, each closer to the target than all with fewer cables, or the first
  // that stands. Of those with as many cables one that stands, if there is one.
  std::vector<Solution> best() const;

 private:
  std::map<int, Solution> closest_;
  std::map<int, Solution> standing_;
};

}  // namespace tencer::elimination
