#include "drawing/strokes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace tencer::app {
namespace {

constexpr double visible = 0.12;  // mm

// Within [0, length], in order, at least so far apart.
std::vector<Gap> tidied(std::vector<Gap> gaps, bool closed, double length, double least) {
  const std::size_t given = gaps.size();
  for (std::size_t i = 0; i < given && closed; ++i)
    for (const double turn : {-length, length}) {
      gaps.push_back(gaps[i]);
      gaps.back().from += turn;
      gaps.back().to += turn;
    }
  for (Gap& gap : gaps) {
    if (gap.from < 0) gap.from = gap.slant_from = 0;
    if (gap.to > length) gap.to = length, gap.slant_to = 0;
  }
  std::erase_if(gaps, [](const Gap& gap) { return gap.from >= gap.to; });
  std::ranges::sort(gaps, {}, &Gap::from);
  std::vector<Gap> apart;
  for (const Gap& gap : gaps) {
    if (apart.empty() || gap.from > apart.back().to + least) {
      apart.push_back(gap);
    } else if (gap.to > apart.back().to) {
      apart.back().to = gap.to;
      apart.back().slant_to = gap.slant_to;
    }
  }
  return apart;
}

// On a closed line also beyond its ends.
Eigen::Vector2d point_on(const Path& line, const Eigen::VectorXd& along, double length) {
  const double whole = along[along.size() - 1];
  if (along.size() > line.cols()) length -= whole * std::floor(length / whole);
  const auto after = std::upper_bound(along.begin() + 1, along.end() - 1, length);
  const Eigen::Index i = after - along.begin();
  const double edge = along[i] - along[i - 1];
  const double t = edge > 0 ? std::clamp((length - along[i - 1]) / edge, 0.0, 1.0) : 0;
  return (1 - t) * line.col(i - 1) + t * line.col(i % line.cols());
}

// The part of a line between two lengths along it.
Path part(const Path& line, const Eigen::VectorXd& along, double from, double to) {
  std::vector<Eigen::Vector2d> points;
  points.push_back(from > 0 ? point_on(line, along, from) : line.col(0));
  for (Eigen::Index i = 0; i < along.size(); ++i) {
    const Eigen::Vector2d point = line.col(i % line.cols());
    if (along[i] > from && along[i] < to && (point - points.back()).norm() > visible)
      points.push_back(point);
  }
  const Eigen::Index last = along.size() - 1;
  points.push_back(to < along[last] ? point_on(line, along, to) : line.col(last % line.cols()));
  Path result(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    result.col(static_cast<Eigen::Index>(i)) = points[i];
  return result;
}

// The first stroke goes on where the last one ends.
void join_over_seam(std::vector<Stroke>& strokes) {
  const Stroke first = strokes.front();
  Stroke& last = strokes.back();
  Path whole(2, last.line.cols() + first.line.cols() - 1);
  whole << last.line, first.line.rightCols(first.line.cols() - 1);
  last.line = std::move(whole);
  last.to += first.to;
  last.slant_to = first.slant_to;
  strokes.erase(strokes.begin());
}

Eigen::Vector2d left_of(const Eigen::Vector2d& direction) {
  return {-direction.y(), direction.x()};
}

// Of the unit length, at every point.
Path directions(const Path& line) {
  const Eigen::Index n = line.cols();
  Path result(2, n);
  for (Eigen::Index i = 0; i < n; ++i)
    result.col(i) = (line.col(std::min(i + 1, n - 1)) - line.col(std::max<Eigen::Index>(i - 1, 0)))
                        .normalized();
  return result;
}

// One side of a stroke, `aside` to its left.
std::vector<Eigen::Vector2d> side_of(const Stroke& stroke, double aside, double begin, double end) {
  const Path along = directions(stroke.line);
  const Eigen::VectorXd lengths = lengths_along(stroke.line, false);
  const Eigen::Index last = lengths.size() - 1;
  std::vector<Eigen::Vector2d> side;
  const auto add = [&](Eigen::Index i, double further) {
    side.emplace_back(stroke.line.col(i) + aside * left_of(along.col(i)) + further * along.col(i));
  };
  add(0, begin);
  for (Eigen::Index i = 1; i < last; ++i)
    if (lengths[i] > begin && lengths[i] < lengths[last] + end) add(i, 0);
  add(last, end);
  return side;
}

double distance_to(const Path& line, const Eigen::VectorXd& along, double from, double to,
                   const Eigen::Vector2d& point) {
  constexpr int steps = 24;
  double least = std::numeric_limits<double>::infinity();
  Eigen::Vector2d a = point_on(line, along, from);
  for (int i = 1; i <= steps; ++i) {
    const Eigen::Vector2d b = point_on(line, along, from + (to - from) * i / steps);
    const Eigen::Vector2d edge = b - a;
    const double square = edge.squaredNorm();
    const double t = square > 0 ? std::clamp(edge.dot(point - a) / square, 0.0, 1.0) : 0;
    least = std::min(least, (a + t * edge - point).norm());
    a = b;
  }
  return least;
}

// Where a line goes at some length along it.
Eigen::Vector2d direction_on(const Spotted& spot) {
  constexpr double step = 0.25;
  const Eigen::Vector2d way = point_on(spot.line, spot.lengths, spot.at + step) -
                              point_on(spot.line, spot.lengths, spot.at - step);
  return way.norm() > 0 ? Eigen::Vector2d(way.normalized()) : Eigen::Vector2d::UnitX();
}

}  // namespace

Eigen::VectorXd lengths_along(const Path& line, bool closed) {
  const Eigen::Index n = line.cols();
  Eigen::VectorXd along(closed ? n + 1 : n);
  along[0] = 0;
  for (Eigen::Index i = 1; i < along.size(); ++i)
    along[i] = along[i - 1] + (line.col(i % n) - line.col(i - 1)).norm();
  return along;
}

std::vector<Stroke> strokes(const Path& line, bool closed, std::vector<Gap> gaps, double least) {
  const Eigen::VectorXd along = lengths_along(line, closed);
  const double length = along[along.size() - 1];
  std::vector<Stroke> result;
  Stroke next{{}, 0, length, 0, 0};
  const auto put = [&] {
    if (next.from >= next.to) return;
    next.line = part(line, along, next.from, next.to);
    result.push_back(next);
  };
  for (const Gap& gap : tidied(std::move(gaps), closed, length, least)) {
    next.to = gap.from;
    next.slant_to = gap.slant_from;
    put();
    next = {{}, gap.to, length, gap.slant_to, 0};
  }
  put();
  if (closed && result.size() > 1 && result.front().from == 0 && result.back().to == length)
    join_over_seam(result);
  return result;
}

Path outline(const Stroke& stroke, double width) {
  const std::vector<Eigen::Vector2d> left =
      side_of(stroke, width / 2, stroke.slant_from / 2, stroke.slant_to / 2);
  const std::vector<Eigen::Vector2d> right =
      side_of(stroke, -width / 2, -stroke.slant_from / 2, -stroke.slant_to / 2);
  Path corners(2, static_cast<Eigen::Index>(left.size() + right.size()));
  Eigen::Index i = 0;
  for (const Eigen::Vector2d& corner : left) corners.col(i++) = corner;
  for (auto corner = right.rbegin(); corner != right.rend(); ++corner) corners.col(i++) = *corner;
  return corners;
}

Gap gap_under(const Spotted& over, const Spotted& under, double clear, double under_width) {
  constexpr double longest = 7;       // times `clear`, to either side
  constexpr double step = 0.1;        // of `clear`
  constexpr double most_slant = 0.9;  // of the width
  const Eigen::Vector2d along = direction_on(under);
  const Eigen::Vector2d across = direction_on(over);
  const double sine = along.x() * across.y() - along.y() * across.x();
  // The line over passes a point to the left of the one under by so much further along.
  const double slant = sine == 0 ? 0 : under_width * along.dot(across) / sine;
  const double kept = std::clamp(slant, -most_slant * under_width, most_slant * under_width);
  const double reach = (longest + 1) * clear;
  const auto end = [&](double sign) {
    double away = 0;
    while (away < longest * clear &&
           distance_to(over.line, over.lengths, over.at - reach, over.at + reach,
                       point_on(under.line, under.lengths, under.at + sign * away)) < clear)
      away += step * clear;
    return away + std::abs(slant - kept) / 2;
  };
  return {under.at - end(-1), under.at + end(1), kept, kept};
}

}  // namespace tencer::app
