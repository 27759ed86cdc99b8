#include "curves/drawing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "curves/finish_curve.hpp"
#include "curves/join_ends.hpp"
#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

// Numbers points so that those nearer to each other than `reach` have the same; where many are so
// near, the first of them decides.
class Points {
 public:
  explicit Points(double reach) : reach_(reach) {}

  int number(const Eigen::Vector3d& point) {
    const Cell here = cell(point);
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz) {
          const auto found = cells_.find(
              Cell(std::get<0>(here) + dx, std::get<1>(here) + dy, std::get<2>(here) + dz));
          if (found == cells_.end()) continue;
          for (const int known : found->second)
            if ((points_[known] - point).norm() <= reach_) return known;
        }
    points_.push_back(point);
    cells_[here].push_back(static_cast<int>(points_.size()) - 1);
    return static_cast<int>(points_.size()) - 1;
  }
  const Eigen::Vector3d& operator[](int number) const { return points_[number]; }

 private:
  using Cell = std::tuple<double, double, double>;
  Cell cell(const Eigen::Vector3d& point) const {
    return {std::floor(point.x() / reach_), std::floor(point.y() / reach_),
            std::floor(point.z() / reach_)};
  }

  double reach_;
  std::vector<Eigen::Vector3d> points_;
  std::map<Cell, std::vector<int>> cells_;
};

double size_of(const std::vector<Stroke>& strokes) {
  Eigen::AlignedBox3d box;
  for (const Stroke& stroke : strokes)
    for (const Piece& piece : stroke.pieces)
      for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) box.extend(piece.at(t));
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

std::vector<Piece> pieces_of(const Run& run, const std::vector<Stroke>& strokes) {
  std::vector<Piece> result;
  for (const Run::Part& part : run.parts) {
    std::vector<Piece> pieces = strokes[part.piece].pieces;
    if (part.reversed) {
      std::ranges::reverse(pieces);
      for (Piece& piece : pieces) piece = reversed(piece);
    }
    result.insert(result.end(), pieces.begin(), pieces.end());
  }
  return result;
}

}  // namespace

void add_strokes(const std::vector<Stroke>& strokes, CurveFile& file) {
  constexpr double meeting = 1e-4;  // of the drawing's size
  Points points(std::max(meeting * size_of(strokes), std::numeric_limits<double>::min()));
  std::vector<PieceEnds> ends;
  for (const Stroke& stroke : strokes) {
    const int from = points.number(stroke.pieces.front().from());
    ends.push_back({from, stroke.closed ? from : points.number(stroke.pieces.back().to())});
  }
  const auto runs = join_ends(ends, [&](int stroke, int point) {
    fail(strokes[stroke].where, "three lines end at (" + to_text(points[point].x() + 0.0) + ", " +
                                    to_text(points[point].y() + 0.0) +
                                    "); a rod cannot branch, so leave out all but the rods");
  });
  for (const Run& run : runs) {
    ListedCurve curve;
    curve.where = strokes[run.parts.front().piece].where;
    curve.points = points_along(pieces_of(run, strokes));
    if (run.closed) curve.points.back() = curve.points.front();
    check_drawn(curve);
    curve.where_of = [&](int) { return curve.where; };
    curve.name_of = [&](int i) {
      return "(" + to_text(curve.points[i].x()) + ", " + to_text(curve.points[i].y()) + ")";
    };
    finish_curve(curve, file);
  }
}

}  // namespace tencer::io
