// The networks a search has found so far: of each number of cables the closest to the target.
#pragma once

#include <map>
#include <tencer/sparsify/thin.hpp>
#include <vector>

namespace tencer::sparsify {

class Pool {
 public:
  void add(Choice choice);
  void add(Pool other);

  // What is asked for, or what comes nearest to it; null when there is nothing.
  const Choice* answer(const ThinOptions& options) const;

  // The fewest cables first, each closer to the target than all with fewer cables.
  std::vector<Choice> best() const;

 private:
  std::map<int, Choice> closest_;
};

int cables_of(const Choice& choice);

// Whether `next` answers clearly better than `choice` what is asked for.
bool better(const Choice& next, const Choice& choice, const ThinOptions& options);

}  // namespace tencer::sparsify
