#include "fabricate/labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tencer::app {
namespace {

// mm for which a place may be further away to hide one point less.
constexpr double hidden_point = 1.5;
// Over other words, or off the paper: only when there is no other place.
constexpr double last_resort = 1e4;

double x_of(const Eigen::Vector2d& point) { return point.x(); }

}  // namespace

Labels::Labels(const Eigen::AlignedBox2d& bounds, std::vector<Eigen::Vector2d> busy)
    : bounds_(bounds), busy_(std::move(busy)) {
  std::ranges::sort(busy_, {}, x_of);
}

double Labels::cost(const Eigen::AlignedBox2d& box) const {
  double sum = bounds_.contains(box) ? 0 : last_resort;
  for (const auto& other : placed_)
    if (other.intersects(box)) sum += last_resort;
  if (sum > 0) return sum;
  for (auto point = std::ranges::lower_bound(busy_, box.min().x(), {}, x_of);
       point != busy_.end() && point->x() <= box.max().x(); ++point)
    if (box.contains(*point)) sum += hidden_point;
  return sum;
}

Eigen::Vector2d Labels::place(const std::vector<Eigen::Vector2d>& anchors,
                              const Eigen::Vector2d& size, bool on) {
  constexpr int directions = 16;
  constexpr int rings = 12;
  const double step = size.minCoeff();
  Eigen::Vector2d best = anchors.front();
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Eigen::Vector2d& middle, double distance) {
    const double total =
        distance + (distance < least ? cost({middle - size / 2, middle + size / 2}) : last_resort);
    if (total < least) {
      least = total;
      best = middle;
    }
  };
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const double later = 0.3 * static_cast<double>(i);
    if (on) offer(anchors[i], later);
    for (int ring = 1; ring <= rings; ++ring)
      for (int d = 0; d < directions; ++d) {
        const double angle = 2 * std::numbers::pi * d / directions;
        const Eigen::Vector2d away(std::cos(angle) * (size.x() / 2 + step * (ring - 0.3)),
                                   std::sin(angle) * (size.y() / 2 + step * (ring - 0.3)));
        offer(anchors[i] + away, later + (on ? 4 : 0) + step * ring);
      }
  }
  placed_.emplace_back(best - size / 2, best + size / 2);
  return best;
}

}  // namespace tencer::app
