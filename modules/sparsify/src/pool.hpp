// The networks a search has found so far: of each number of cables the closest to the target, and
// the closest that settles from the target.
#pragma once

#include <map>
#include <tencer/sparsify/thin.hpp>
#include <vector>

namespace tencer::sparsify {

class Pool {
 public:
  void add(Choice choice);
  void add(const Pool& other);

  // What is asked for, or what comes nearest to it; null when there is nothing. One that settles
  // from the target comes before all that do not: if it is within the error asked for, or with a
  // number of cables asked for, if it is at most twice as far away.
  const Choice* answer(const ThinOptions& options) const;

  // The fewest cables first, each closer to the target than all with fewer cables. Of those with as
  // many cables one that settles, if there is one.
  std::vector<Choice> best() const;

 private:
  std::map<int, Choice> closest_;
  std::map<int, Choice> settling_;
};

int cables_of(const Choice& choice);

// Whether `next` answers clearly better than `choice` what is asked for.
bool better(const Choice& next, const Choice& choice, const ThinOptions& options);

}  // namespace tencer::sparsify
