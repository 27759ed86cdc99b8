#include "fabricate/strokes.hpp"

#include <algorithm>

namespace tencer::app {
namespace {

constexpr double visible = 0.12;  // mm

// Within [0, length], in order, none overlapping another.
std::vector<Gap> tidied(std::vector<Gap> gaps, bool closed, double length) {
  const std::size_t given = gaps.size();
  for (std::size_t i = 0; i < given && closed; ++i)
    for (const double turn : {-length, length})
      gaps.push_back({gaps[i].from + turn, gaps[i].to + turn});
  for (Gap& gap : gaps) gap = {std::max(gap.from, 0.0), std::min(gap.to, length)};
  std::erase_if(gaps, [](const Gap& gap) { return gap.from >= gap.to; });
  std::ranges::sort(gaps, {}, &Gap::from);
  std::vector<Gap> apart;
  for (const Gap& gap : gaps) {
    if (!apart.empty() && gap.from <= apart.back().to)
      apart.back().to = std::max(apart.back().to, gap.to);
    else
      apart.push_back(gap);
  }
  return apart;
}

// The part of a line between two lengths along it.
Path part(const Path& line, const Eigen::VectorXd& along, double from, double to) {
  std::vector<Eigen::Vector2d> points;
  const auto at = [&](double length) -> Eigen::Vector2d {
    const auto after = std::upper_bound(along.begin() + 1, along.end() - 1, length);
    const Eigen::Index i = after - along.begin();
    const double edge = along[i] - along[i - 1];
    const double t = edge > 0 ? (length - along[i - 1]) / edge : 0;
    return (1 - t) * line.col(i - 1) + t * line.col(i % line.cols());
  };
  points.push_back(at(from));
  for (Eigen::Index i = 0; i < along.size(); ++i) {
    const Eigen::Vector2d point = line.col(i % line.cols());
    if (along[i] > from && along[i] < to && (point - points.back()).norm() > visible)
      points.push_back(point);
  }
  points.push_back(at(to));
  Path result(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    result.col(static_cast<Eigen::Index>(i)) = points[i];
  return result;
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

std::vector<Path> strokes(const Path& line, bool closed, std::vector<Gap> gaps) {
  const Eigen::VectorXd along = lengths_along(line, closed);
  const double length = along[along.size() - 1];
  std::vector<Path> result;
  double from = 0;
  for (const Gap& gap : tidied(std::move(gaps), closed, length)) {
    if (gap.from > from) result.push_back(part(line, along, from, gap.from));
    from = gap.to;
  }
  if (from < length) result.push_back(part(line, along, from, length));
  return result;
}

}  // namespace tencer::app
