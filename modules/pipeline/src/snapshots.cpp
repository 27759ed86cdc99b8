#include "snapshots.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace tencer::pipeline {
namespace {

bool look_alike(const model::Snapshot& a, const model::Snapshot& b) {
  constexpr double same = 1e-3;  // of the error
  return a.cables() == b.cables() &&
         std::abs(a.max_percent - b.max_percent) <= same * std::max(a.max_percent, b.max_percent);
}

}  // namespace

void thin_snapshots(std::vector<model::StageRow>& trace, int most) {
  std::vector<std::pair<model::StageRow*, model::Snapshot>> kept;
  for (model::StageRow& row : trace) {
    for (model::Snapshot& snapshot : row.snapshots)
      if (kept.empty() || !look_alike(kept.back().second, snapshot))
        kept.emplace_back(&row, std::move(snapshot));
    row.snapshots.clear();
  }
  const auto count = static_cast<int>(kept.size());
  const int shown = std::min(count, most);
  for (int i = 0; i < shown; ++i) {
    auto& [row, snapshot] = kept[shown == 1 ? 0 : i * (count - 1) / (shown - 1)];
    row->snapshots.push_back(std::move(snapshot));
  }
}

void unscale_snapshots(std::vector<model::StageRow>& trace, const model::Scaling& scaling) {
  for (model::StageRow& row : trace)
    for (model::Snapshot& snapshot : row.snapshots) {
      for (auto& points : snapshot.rods) points = scaling.unscaled(points);
      snapshot.cable_ends = scaling.unscaled(snapshot.cable_ends);
      snapshot.tensions *= scaling.scale.force();
    }
}

}  // namespace tencer::pipeline
