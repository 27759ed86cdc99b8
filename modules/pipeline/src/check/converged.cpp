#include <algorithm>
#include <tencer/pipeline/simulate.hpp>

#include "check/pose.hpp"

namespace tencer::pipeline {

// Halving edges quarters the error, so what is left beyond the last step is a third of it.
std::optional<model::Converged> converged(const model::Design& design,
                                          const CheckOptions& options) {
  constexpr double least_percent = 0.01;  // of the size, where the max error is about nothing
  const double size = size_of(design);
  model::Converged result{.allowed = std::max(0.1 * design.error->max_percent, least_percent) /
                                     100 * size};
  model::Design coarse = design;
  for (const int times : {2, 4, 8}) {
    if (options.stop.stop_requested()) break;
    auto fine = simulate(coarse, {.refine = 2, .solve = {.stop = options.stop}});
    const bool settles = fine && fine->usable();
    const double moved = fine ? fine->moved_percent / 100 * size : 0;
    result.refinements.push_back({.times = times, .moved = moved, .settles = settles});
    if (!settles) break;
    result.distance += moved;
    result.converged = moved < result.allowed;
    if (result.converged) break;
    coarse = std::move((*fine).design);
  }
  if (result.refinements.empty()) return std::nullopt;
  if (result.refinements.back().settles) result.distance += result.refinements.back().moved / 3;
  return result;
}

}  // namespace tencer::pipeline
