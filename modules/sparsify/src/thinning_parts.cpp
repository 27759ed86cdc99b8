#include <algorithm>

#include "fit.hpp"
#include "parallel.hpp"
#include "thinning.hpp"

namespace tencer::sparsify {
namespace {

int cables_of(const Network& network) { return static_cast<int>(network.structure.cables.size()); }

// Of descents, those that end with the fewest cables first.
std::vector<int> order_of(const std::vector<std::vector<Network>>& paths) {
  std::vector<int> order;
  for (int k = 0; k < static_cast<int>(paths.size()); ++k)
    if (!paths[k].empty()) order.push_back(k);
  std::ranges::stable_sort(order, {}, [&](int k) { return cables_of(paths[k].back()); });
  return order;
}

}  // namespace

bool Thinning::thin_part(Walker& whole, const Part& part) {
  // Rods that may be far from their targets for their size are steered closer: steps stay small.
  constexpr double most_percent = 1.0;
  constexpr double worn = 0.4;  // of the accepted distance
  const double diagonal = diagonal_of(part.target);
  const double percent = std::min(steered_percent() * diagonal_ / diagonal, most_percent);
  Task task = task_for(part.network, part.target, part.rules, nullptr, options_);
  task.kept = part.kept;
  const int needed = cables_of(part.network) - (whole.cables() - options_.cables);
  std::vector<std::vector<Network>> paths(temper_count);
  in_parallel(temper_count, options_.threads, [&](int temper) {
    Walker walker(part.network, task, {}, control_);
    if (!walker.usable()) return;
    DescentOptions options = descent(temper, percent);
    options.diagonal = diagonal;
    options.fewest = std::max(part.kept + 1, options_.cables > 0 ? needed : 0);
    options.progress = {};
    paths[temper] = descend(walker, options);
    count(walker);
  });
  // What holds while other rods are held need not hold when they are free.
  constexpr std::size_t tried = 2;
  const Network before = whole.network();
  const auto order = order_of(paths);
  for (std::size_t k = 0; k < std::min(tried, order.size()); ++k) {
    const auto& path = paths[order[k]];
    for (std::size_t at = path.size() - 1; at > 0; at /= 2) {
      if (!whole.restart(with_part(before, part, path[at]))) continue;
      if (whole.deviation().max_percent > steered_percent()) continue;
      // What is lost with each part adds up over the whole.
      if (whole.deviation().max_percent > worn * steered_percent()) whole.refit(2);
      report(whole);
      return true;
    }
  }
  whole.restart(before);
  return false;
}

Network Thinning::by_parts(const Network& start) {
  constexpr int most_sweeps = 6;
  Walker whole(start, task_, {}, control_);
  if (!whole.usable()) return start;
  const auto parts = joined_rods(start.structure);
  int now = 0;
  std::vector<int> changed(start.structure.rods.size(), ++now);  // when, for each rod
  std::vector<int> tried(parts.size(), 0);
  for (int sweep = 0; sweep < most_sweeps && !whole.stopped(); ++sweep) {
    const int before = now;
    whole.set({.aim = {.unit = steered_percent() / 100 * diagonal_}, .softness = 0.5});
    whole.refit(3);
    for (std::size_t p = 0; p < parts.size() && !whole.stopped(); ++p) {
      const auto& rods = parts[p];
      if (std::ranges::none_of(rods, [&](int r) { return changed[r] > tried[p]; })) continue;
      const bool thinner =
          thin_part(whole, part_of(whole.network(), task_.target, task_.rules, rods));
      tried[p] = ++now;
      if (thinner)
        for (const int r : rods) changed[r] = now;
    }
    if (now == before) break;
  }
  count(whole);
  return whole.network();
}

}  // namespace tencer::sparsify
