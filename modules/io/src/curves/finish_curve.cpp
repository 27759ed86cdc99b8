#include "curves/finish_curve.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

constexpr double negligible = 1e-9;  // relative to the curve's bounding-box diagonal

// 1 + cosine of the turning angle below which a turn counts as straight back.
constexpr double straight_back = 1e-10;

double negligible_length(const Eigen::Matrix3Xd& points) {
  return negligible * (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
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

geometry::Polyline finish_curve(const ListedCurve& curve) {
  int n = static_cast<int>(curve.points.size());
  if (n < 2) fail(curve.where, "a curve needs at least 2 points, found " + std::to_string(n));
  geometry::Polyline result{Eigen::Matrix3Xd(3, n), false};
  for (int i = 0; i < n; ++i) result.points.col(i) = curve.points[i];

  const bool repeats = n > 2 && (curve.points.front() - curve.points.back()).norm() <=
                                    negligible_length(result.points);
  if (repeats && curve.closed == false)
    fail(curve.where,
         "closed is false, but the last point repeats the first; set closed to true, or remove the "
         "last point");
  const bool closed = curve.closed.value_or(repeats);
  if (repeats) --n;
  if (closed && n < 3)
    fail(curve.where,
         "a closed curve needs at least 3 different points, found " + std::to_string(n));

  result.points.conservativeResize(3, n);
  result.closed = closed;
  if (const auto bad = bad_edge(result)) {
    if (bad->no_length)
      fail(curve.where_of(bad->to), "zero-length edge: " + curve.name_of(bad->to) + " repeats " +
                                        curve.name_of(bad->from) + "; remove one of them");
    fail(curve.where_of(bad->from),
         "the curve turns straight back at " + curve.name_of(bad->from) +
             ", where no elastic rod can follow; remove this point or move it");
  }
  return result;
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
