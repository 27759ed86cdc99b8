// The networks found so far: of each number of cables the closest to the target, and the closest
// that settles from the target.
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
  // that settles comes before all that do not when Goal::prefers_settling says so.
  const Solution* best_for(const model::Goal& goal) const;

  // The fewest cables first, each closer to the target than all with fewer cables. Of those with as
  // many cables one that settles, if there is one.
  std::vector<Solution> best() const;

 private:
  std::map<int, Solution> closest_;
  std::map<int, Solution> settling_;
};

}  // namespace tencer::elimination
