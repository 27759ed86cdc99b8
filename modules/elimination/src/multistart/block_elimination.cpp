#include "multistart/block_elimination.hpp"

#include <algorithm>
#include <tencer/network/parallel.hpp>

#include "moves/block.hpp"

namespace tencer::elimination {
namespace {

using network::Network;
using Path = std::vector<Network>;

// The numbers of the eliminations, those that end with the fewest cables first.
std::vector<int> order_of(const std::vector<Path>& paths) {
  std::vector<int> order;
  for (int k = 0; k < static_cast<int>(paths.size()); ++k)
    if (!paths[k].empty()) order.push_back(k);
  std::ranges::stable_sort(order, {}, [&](int k) { return cable_count(paths[k].back()); });
  return order;
}

// Eliminations of the block alone, one for each setting of the portfolio.
std::vector<Path> eliminate_block(Multistart& multistart, const Block& block, int min_cables) {
  // Rods that may be far from their targets for their size are steered closer: steps stay small.
  constexpr double max_aim_percent = 1.0;
  const EliminationOptions& options = multistart.options();
  const double diagonal = model::diagonal(block.target);
  const double percent =
      std::min(multistart.aim_percent() * multistart.diagonal() / diagonal, max_aim_percent);
  Requirements requirements =
      requirements_for(block.network, block.target, block.rules, nullptr, options);
  requirements.fixed_cables = block.fixed_cables;
  std::vector<Path> paths(options.portfolio.size());
  network::in_parallel(static_cast<int>(paths.size()), options.threads, [&](int k) {
    FittedNetwork fitted = multistart.fitted(block.network, requirements);
    if (!fitted.usable()) return;
    Descent descent = multistart.descent(options.portfolio[k], percent);
    descent.diagonal = diagonal;
    descent.min_cables = min_cables;
    descent.progress = {};
    paths[k] = eliminate_backward(fitted, descent, options.removal);
    multistart.count(fitted);
  });
  return paths;
}

// Takes cables out of the block's rods; false: takes nothing out.
bool eliminate_in_block(Multistart& multistart, FittedNetwork& whole, const Block& block) {
  const EliminationOptions& options = multistart.options();
  const int needed = cable_count(block.network) - (whole.cables() - options.goal.cables);
  const auto paths = eliminate_block(
      multistart, block, std::max(block.fixed_cables + 1, options.goal.by_number() ? needed : 0));
  // What holds while other rods are held need not hold when they are free.
  const Network before = whole.network();
  const auto order = order_of(paths);
  const auto tried = std::min(static_cast<std::size_t>(options.block.tried), order.size());
  for (std::size_t k = 0; k < tried; ++k) {
    const Path& path = paths[order[k]];
    for (std::size_t at = path.size() - 1; at > 0; at /= 2) {
      if (!whole.restart(with_block(before, block, path[at]))) continue;
      if (whole.deviation().max_percent > multistart.aim_percent()) continue;
      // What is lost with each block adds up over the whole.
      if (whole.deviation().max_percent > options.block.refit_above * multistart.aim_percent())
        whole.refit(2);
      multistart.report(whole);
      return true;
    }
  }
  whole.restart(before);
  return false;
}

}  // namespace

Network eliminate_in_blocks(Multistart& multistart, const Network& start) {
  const BlockOptions& options = multistart.options().block;
  const Requirements& requirements = multistart.requirements();
  FittedNetwork whole = multistart.fitted(start, requirements);
  if (!whole.usable()) return start;
  const auto blocks = joined_rods(start.structure);
  int now = 0;
  std::vector<int> changed(start.structure.rods.size(), ++now);  // when, for each rod
  std::vector<int> tried(blocks.size(), 0);
  for (int sweep = 0; sweep < options.max_sweeps && !whole.stopped(); ++sweep) {
    const int before = now;
    whole.set({.norm = {.unit = multistart.aim_percent() / 100 * multistart.diagonal()},
               .stability_weight = 0.5});
    whole.refit(3);
    for (std::size_t b = 0; b < blocks.size() && !whole.stopped(); ++b) {
      const auto& rods = blocks[b];
      if (std::ranges::none_of(rods, [&](int r) { return changed[r] > tried[b]; })) continue;
      const bool fewer =
          eliminate_in_block(multistart, whole,
                             block_of(whole.network(), requirements.target, requirements.rules,
                                      rods, options.soft_rest_ratio));
      tried[b] = ++now;
      if (fewer)
        for (const int r : rods) changed[r] = now;
    }
    if (now == before) break;
  }
  multistart.count(whole);
  return whole.network();
}

}  // namespace tencer::elimination
