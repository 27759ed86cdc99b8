#include "scene/vertex_limit.hpp"

#include <algorithm>
#include <tencer/geometry/sampling.hpp>

#include "text/bad_input.hpp"

namespace tencer::io {

void limit_vertices(std::vector<geometry::Polyline>& curves, const std::string& file,
                    std::vector<std::string>& notes) {
  constexpr int fewest = 10;  // of a curve that loses some
  double all = 0;
  for (const geometry::Polyline& curve : curves) all += curve.vertices();
  if (all <= most_vertices) return;
  if (static_cast<double>(curves.size()) * fewest > most_vertices)
    fail(file, "holds " + std::to_string(curves.size()) +
                   " curves, more than can be rods of one scene; save those that are rods");
  const double part = (most_vertices - fewest * static_cast<double>(curves.size())) / all;
  for (geometry::Polyline& curve : curves) {
    const int n = fewest + static_cast<int>(part * curve.vertices());
    if (n < curve.vertices()) curve = geometry::resample(curve, n);
  }
  notes.push_back(file + ": of " + std::to_string(static_cast<long>(all)) + " points about " +
                  std::to_string(most_vertices) + " are taken, evenly along the curves");
}

}  // namespace tencer::io
