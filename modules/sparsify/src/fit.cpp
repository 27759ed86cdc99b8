#include "fit.hpp"

#include <algorithm>
#include <tencer/geometry/measure.hpp>
#include <vector>

#include "descent.hpp"

namespace tencer::sparsify {

double diagonal_of(const sensitivity::Target& target) {
  std::vector<geometry::Polyline> curves;
  for (const auto& points : target.points) curves.push_back({.points = points});
  return geometry::bounding_box_diagonal(curves);
}

void fit(Walker& walker, const sensitivity::Target& target, Measure measure, double softness) {
  constexpr double nearly_largest = 8;  // the power of the norm
  constexpr int rounds = 3;
  const double diagonal = diagonal_of(target);
  const bool largest = measure == Measure::largest;
  const auto error = [&] {
    return largest ? walker.deviation().max_percent : walker.deviation().rms_percent;
  };
  for (int round = 0; round < rounds; ++round) {
    const double before = error();
    walker.set({.aim = {.unit = std::max(before, finest_percent) / 100 * diagonal,
                        .power = largest && round > 0 ? nearly_largest : 2.0},
                .softness = softness});
    walker.refit(6, 0.03);
    if (round > 0 && error() > 0.95 * before) break;
  }
}

}  // namespace tencer::sparsify
