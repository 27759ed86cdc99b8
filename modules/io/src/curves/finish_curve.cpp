#include "curves/finish_curve.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numeric>
#include <sstream>
#include <tencer/io/curve.hpp>

#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

// 1 + cosine of the turning angle below which a turn counts as straight back.
constexpr double straight_back = 1e-10;

double negligible_length(const Eigen::Matrix3Xd& points) {
  constexpr double relative = 1e-9;  // to the bounding box's diagonal
  return relative * (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

// The indices of points that do not repeat the one before them.
std::vector<int> different(const std::vector<Eigen::Vector3d>& points, double gap) {
  std::vector<int> kept;
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    if (kept.empty() || (points[i] - points[kept.back()]).norm() > gap) kept.push_back(i);
  return kept;
}

Eigen::Matrix3Xd matrix_of(const std::vector<Eigen::Vector3d>& points,
                           const std::vector<int>& kept) {
  Eigen::Matrix3Xd matrix(3, kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) matrix.col(i) = points[kept[i]];
  return matrix;
}

// Whether an end that does not quite meet the start is meant to.
struct Ends {
  double gap = 0.0;
  double mean_edge = 0.0;
  double longest_edge = 0.0;

  bool nearly_meet() const { return gap <= 0.01 * mean_edge; }
  bool neighbours() const { return gap <= 2 * longest_edge; }
};

Ends ends_of(const Eigen::Matrix3Xd& points) {
  const Eigen::VectorXd lengths = geometry::edge_lengths({points, false});
  return {.gap = (points.col(0) - points.rightCols(1)).norm(),
          .mean_edge = lengths.mean(),
          .longest_edge = lengths.maxCoeff()};
}

std::string rounded(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

// Whether a curve whose last point does not repeat its first is closed; what is not told but taken
// so, or may be meant otherwise, goes to the notes.
bool closes(const ListedCurve& curve, std::vector<int>& kept, CurveFile& file) {
  constexpr std::size_t fewest = 8;  // points from which two ends are neighbours by no chance
  if (kept.size() < 4) return curve.closed.value_or(false);
  const Ends ends = ends_of(matrix_of(curve.points, kept));
  if (ends.nearly_meet() && curve.closed == false)
    fail(curve.where,
         "closed is false, but the ends are " + rounded(ends.gap) +
             " apart, less than 1 % of an edge; set closed to true, or move them apart");
  if (ends.nearly_meet()) {
    kept.pop_back();
    file.notes.push_back(curve.where + ": the ends of this curve are " + rounded(ends.gap) +
                         " apart: it is taken as closed");
    return true;
  }
  if (!curve.closed && kept.size() >= fewest && ends.neighbours())
    file.open_ends.push_back(
        curve.where + ": this curve is open, with its ends " + rounded(ends.gap) +
        " apart, as far as neighbours; to close it say --closed, or closed = true in a "
        "scene");
  return curve.closed.value_or(false);
}

}  // namespace

double coordinate(std::string_view field, const std::string& where) {
  const auto number = to_number(field);
  if (!number) fail(where, quoted(field) + " is not a number");
  if (!std::isfinite(*number)) fail(where, quoted(field) + " is not a finite number");
  if (std::abs(*number) > largest_number)
    fail(where, quoted(field) + " is too large for a coordinate; use a larger unit of length");
  return *number;
}

void check_drawn(const ListedCurve& curve) {
  for (const Eigen::Vector3d& point : curve.points)
    if (!(point.cwiseAbs().maxCoeff() <= largest_number))
      fail(curve.where, "its numbers are too large, or too different in size, to draw it");
}

void finish_curve(const ListedCurve& curve, CurveFile& file) {
  const auto listed = static_cast<int>(curve.points.size());
  if (listed < 2)
    fail(curve.where, "a curve needs at least 2 points, found " + std::to_string(listed));
  std::vector<int> all(listed);
  std::iota(all.begin(), all.end(), 0);
  const double negligible = negligible_length(matrix_of(curve.points, all));
  std::vector<int> kept = different(curve.points, negligible);
  if (kept.size() < 2) fail(curve.where, "a curve needs at least 2 different points, found 1");
  if (const auto dropped = listed - static_cast<int>(kept.size()); dropped > 0)
    file.notes.push_back(
        curve.where + ": " + std::to_string(dropped) +
        (dropped == 1 ? " point of this curve repeats the one before it and is dropped"
                      : " points of this curve repeat the one before them and are dropped"));

  const bool repeats =
      kept.size() > 2 &&
      (curve.points[kept.front()] - curve.points[kept.back()]).norm() <= negligible;
  if (repeats && curve.closed == false)
    fail(curve.where,
         "closed is false, but the last point repeats the first; set closed to true, or remove the "
         "last point");
  if (repeats) kept.pop_back();
  const bool closed = repeats || closes(curve, kept, file);
  if (closed && kept.size() < 3)
    fail(curve.where,
         "a closed curve needs at least 3 different points, found " + std::to_string(kept.size()));

  geometry::Polyline result{matrix_of(curve.points, kept), closed};
  if (const auto bad = bad_edge(result))
    fail(curve.where_of(kept[bad->from]),
         "the curve turns straight back at " + curve.name_of(kept[bad->from]) +
             ", where no elastic rod can follow; remove this point or move it");
  file.curves.push_back(std::move(result));
}

core::Expected<CurveFile> listed_curve(const Eigen::Ref<const Eigen::Matrix3Xd>& points,
                                       std::optional<bool> closed, const std::string& name) {
  return guarded([&] {
    const auto place = [&](int i) { return name + "[" + std::to_string(i) + "]"; };
    ListedCurve listed;
    listed.closed = closed;
    listed.where = name;
    listed.where_of = listed.name_of = place;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      for (const double number : points.col(i))
        if (!(std::abs(number) <= largest_number))
          fail(place(static_cast<int>(i)),
               to_text(number) + (std::isfinite(number)
                                      ? " is too large for a coordinate; use a larger "
                                        "unit of length"
                                      : " is not a finite number"));
      listed.points.emplace_back(points.col(i));
    }
    CurveFile file;
    finish_curve(listed, file);
    return file;
  });
}

std::optional<std::string> close_curve(geometry::Polyline& curve) {
  constexpr double far = 3;  // times the longest edge
  if (curve.closed) return std::nullopt;
  if (curve.vertices() < 3)
    return "a closed curve needs at least 3 different points, found " +
           std::to_string(curve.vertices());
  const Ends ends = ends_of(curve.points);
  if (ends.gap > far * ends.longest_edge)
    return "the ends of the curve are " + rounded(ends.gap) + " apart, " +
           rounded(ends.gap / ends.longest_edge) +
           " times its longest edge; give it points on the way from one to the other, or leave it "
           "open";
  curve.closed = true;
  if (const auto bad = bad_edge(curve))
    return "closed, the curve turns straight back at its vertex " + std::to_string(bad->from);
  return std::nullopt;
}

std::optional<BadEdge> bad_edge(const geometry::Polyline& curve) {
  const int n = curve.vertices();
  const double short_length = negligible_length(curve.points);
  const Eigen::Matrix3Xd edges = geometry::edge_vectors(curve);
  for (int i = 0; i < curve.edges(); ++i)
    if (edges.col(i).norm() <= short_length) return BadEdge{true, i, (i + 1) % n};
  for (int i = curve.closed ? 0 : 1; i < curve.edges(); ++i) {
    const Eigen::Vector3d before = edges.col((i + n - 1) % n).normalized();
    if (1.0 + before.dot(edges.col(i).normalized()) < straight_back)
      return BadEdge{false, i, (i + 1) % n};
  }
  return std::nullopt;
}

}  // namespace tencer::io
