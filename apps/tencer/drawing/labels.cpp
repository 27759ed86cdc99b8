#include "drawing/labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tencer::app {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

// mm for which a place may be further away to hide one point less.
constexpr double hidden_point = 1.5;
// For a leader over one: it is thin, and hides nothing.
constexpr double crossed_point = 0.15;
// Over other words or leaders, or off the paper: only when there is no other place.
constexpr double last_resort = 1e4;

double x_of(const Vector2d& point) { return point.x(); }

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

bool segments_meet(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  return cross(b - a, c - a) * cross(b - a, d - a) <= 0 &&
         cross(d - c, a - c) * cross(d - c, b - c) <= 0;
}

bool meets(const AlignedBox2d& box, const Vector2d& a, const Vector2d& b) {
  if (box.contains(a) || box.contains(b)) return true;
  const Vector2d low_right(box.max().x(), box.min().y());
  const Vector2d high_left(box.min().x(), box.max().y());
  return segments_meet(a, b, box.min(), box.max()) || segments_meet(a, b, low_right, high_left);
}

}  // namespace

Vector2d edge_towards(const AlignedBox2d& box, const Vector2d& anchor) {
  const Vector2d way = anchor - box.center();
  const Vector2d half = box.sizes() / 2;
  const double part = std::max(std::abs(way.x()) / half.x(), std::abs(way.y()) / half.y());
  return part > 1 ? Vector2d(box.center() + way / part) : anchor;
}

Labels::Labels(const AlignedBox2d& bounds, std::vector<Vector2d> busy)
    : bounds_(bounds), busy_(std::move(busy)) {
  std::ranges::sort(busy_, {}, x_of);
}

double Labels::cost(const AlignedBox2d& box) const {
  double sum = bounds_.contains(box) ? 0 : last_resort;
  for (const auto& other : placed_)
    if (other.intersects(box)) sum += last_resort;
  for (const Placed& leader : leaders_)
    if (meets(box, leader.anchor, leader.middle)) sum += last_resort;
  if (sum > 0) return sum;
  for (auto point = std::ranges::lower_bound(busy_, box.min().x(), {}, x_of);
       point != busy_.end() && point->x() <= box.max().x(); ++point)
    if (box.contains(*point)) sum += hidden_point;
  return sum;
}

double Labels::cost_of_leader(const Vector2d& anchor, const AlignedBox2d& box) const {
  constexpr double beside = 0.5;
  const Vector2d end = edge_towards(box, anchor);
  double sum = 0;
  for (const auto& other : placed_)
    if (meets(other, anchor, end)) sum += last_resort;
  for (const Placed& leader : leaders_)
    if (segments_meet(anchor, end, leader.anchor, leader.middle)) sum += last_resort;
  if (sum > 0) return sum;
  const double from = std::min(anchor.x(), end.x()) - beside;
  const double to = std::max(anchor.x(), end.x()) + beside;
  const Vector2d way = (end - anchor).normalized();
  const double length = (end - anchor).norm();
  for (auto point = std::ranges::lower_bound(busy_, from, {}, x_of);
       point != busy_.end() && point->x() <= to; ++point) {
    const double along = way.dot(*point - anchor);
    // What it starts on does not count.
    if (along > 1 && along < length && std::abs(cross(way, *point - anchor)) < beside)
      sum += crossed_point;
  }
  return sum;
}

Placed Labels::place(const std::vector<Vector2d>& anchors, const Vector2d& size, Beside how) {
  constexpr int directions = 16;
  constexpr int rings = 12;
  const double step = size.minCoeff();
  Placed best{anchors.front(), anchors.front()};
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Placed& place, double distance) {
    if (distance >= least) return;
    const AlignedBox2d box(place.middle - size / 2, place.middle + size / 2);
    double total = distance + cost(box);
    if (how == Beside::leader && total < least) total += cost_of_leader(place.anchor, box);
    if (total < least) {
      least = total;
      best = place;
    }
  };
  const int first_ring = how == Beside::leader ? 2 : 1;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const double later = 0.3 * static_cast<double>(i);
    if (how == Beside::on) offer({anchors[i], anchors[i]}, later);
    for (int ring = first_ring; ring <= rings; ++ring)
      for (int d = 0; d < directions; ++d) {
        const double angle = 2 * std::numbers::pi * d / directions;
        const Vector2d away(std::cos(angle) * (size.x() / 2 + step * (ring - 0.3)),
                            std::sin(angle) * (size.y() / 2 + step * (ring - 0.3)));
        offer({anchors[i] + away, anchors[i]}, later + (how == Beside::on ? 4 : 0) + step * ring);
      }
  }
  best.clear = least < last_resort;
  if (how == Beside::leader && !best.clear) return best;
  const AlignedBox2d box(best.middle - size / 2, best.middle + size / 2);
  placed_.push_back(box);
  if (how == Beside::leader) leaders_.push_back({edge_towards(box, best.anchor), best.anchor});
  return best;
}

}  // namespace tencer::app
