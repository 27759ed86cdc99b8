#include "moves/replacement.hpp"

#include "moves/backward_elimination.hpp"

namespace tencer::elimination {
namespace {

// The best cable that the network bears.
void insert_best(FittedNetwork& fitted, std::span<const springs::Cable> candidates,
                 const LocalSearchOptions& search) {
  constexpr int tried = 3;
  const network::Network before = fitted.network();
  for (const Insertion& insertion : best_insertions(fitted, candidates, tried, search)) {
    for (double part = 1; part > 0.05; part /= 4)
      if (fitted.restart(with_insertion(before, insertion, part))) return fitted.refit(4);
    fitted.restart(before);
  }
}

}  // namespace

bool replace(FittedNetwork& fitted, int first, int count,
             std::span<const springs::Cable> candidates, const LocalSearchOptions& search,
             const RemovalOptions& removal) {
  for (int k = 0; k < 2 * count && !fitted.stopped(); ++k) insert_best(fitted, candidates, search);
  for (int k = 0; k < count; ++k)
    if (!remove(fitted, first - fitted.requirements().fixed_cables, removal)) return false;
  return true;
}

}  // namespace tencer::elimination
