#include <algorithm>
#include <tencer/core/error.hpp>
#include <tencer/geometry/sampling.hpp>
#include <vector>

namespace tencer::geometry {
namespace {

// Chords over which the arc length of a smooth curve is summed.
constexpr int chords = 1 << 15;

double chord_sum(const Curve& curve, double from, double to, int n) {
  double sum = 0.0;
  Eigen::Vector3d previous = curve(from);
  for (int i = 1; i <= n; ++i) {
    const Eigen::Vector3d next = curve(from + (to - from) * i / n);
    sum += (next - previous).norm();
    previous = next;
  }
  return sum;
}

}  // namespace

ArcLength arc_length(const Polyline& curve) { return {edge_lengths(curve), curve.closed}; }

Eigen::Vector3d point_at(const Polyline& curve, const ArcLength& arc, double s) {
  core::require(arc.edges() == curve.edges() && arc.closed() == curve.closed,
                "point_at: the arc length belongs to another curve");
  const auto [edge, t] = arc.locate(s);
  const int next = (edge + 1) % curve.vertices();
  return (1.0 - t) * curve.points.col(edge) + t * curve.points.col(next);
}

Polyline resample(const Polyline& curve, int n) {
  core::require(n >= (curve.closed ? 3 : 2), "resample: too few points");
  const ArcLength arc = arc_length(curve);
  const int intervals = curve.closed ? n : n - 1;
  Polyline result{Eigen::Matrix3Xd(3, n), curve.closed};
  for (int i = 0; i < intervals; ++i)
    result.points.col(i) = point_at(curve, arc, arc.length() * i / intervals);
  if (!curve.closed) result.points.col(n - 1) = curve.points.col(curve.vertices() - 1);
  return result;
}

Eigen::Matrix3Xd slopes(const Eigen::Matrix3Xd& points, const ArcLength& arc) {
  const int n = static_cast<int>(points.cols());
  const auto chord = [&](int edge) -> Eigen::Vector3d {
    return (points.col((edge + 1) % n) - points.col(edge)) / arc.edge_length(edge);
  };
  Eigen::Matrix3Xd slope(3, n);
  for (int i = 0; i < n; ++i) {
    if (!arc.closed() && (i == 0 || i == n - 1)) continue;
    const int before = (i + n - 1) % n;
    const double a = arc.edge_length(before);
    const double b = arc.edge_length(i);
    slope.col(i) = (b * chord(before) + a * chord(i)) / (a + b);
  }
  if (!arc.closed()) {
    slope.col(0) = n > 2 ? Eigen::Vector3d(2 * chord(0) - slope.col(1)) : chord(0);
    slope.col(n - 1) = n > 2 ? Eigen::Vector3d(2 * chord(n - 2) - slope.col(n - 2)) : chord(0);
  }
  return slope;
}

Eigen::Matrix3Xd smooth_points(const Eigen::Matrix3Xd& points, const ArcLength& arc,
                               const Eigen::VectorXd& at) {
  const Eigen::Matrix3Xd slope = slopes(points, arc);
  Eigen::Matrix3Xd result(3, at.size());
  for (Eigen::Index k = 0; k < at.size(); ++k) {
    const auto [edge, t] = arc.locate(at[k]);
    const auto next = (edge + 1) % points.cols();
    const Eigen::Vector3d d = points.col(next) - points.col(edge);
    const Eigen::Vector3d from = arc.edge_length(edge) * slope.col(edge) - d;
    const Eigen::Vector3d to = arc.edge_length(edge) * slope.col(next) - d;
    result.col(k) = points.col(edge) + t * d + t * (1 - t) * ((1 - t) * from - t * to);
  }
  return result;
}

double length(const Curve& curve, double from, double to) {
  // The error of a chord sum is even in the step: one Richardson step removes its first term.
  const double coarse = chord_sum(curve, from, to, chords / 16);
  const double fine = chord_sum(curve, from, to, chords / 8);
  return fine + (fine - coarse) / 3.0;
}

Polyline sample(const Curve& curve, double from, double to, int n, bool closed) {
  core::require(n >= (closed ? 3 : 2) && to > from, "sample: too few points or an empty interval");
  std::vector<double> travelled(chords + 1, 0.0);
  Eigen::Vector3d previous = curve(from);
  for (int i = 1; i <= chords; ++i) {
    const Eigen::Vector3d next = curve(from + (to - from) * i / chords);
    travelled[i] = travelled[i - 1] + (next - previous).norm();
    previous = next;
  }
  const int intervals = closed ? n : n - 1;
  Polyline result{Eigen::Matrix3Xd(3, n), closed};
  for (int i = 0; i < n; ++i) {
    const double s = travelled.back() * i / intervals;
    // The last chord that starts at or before s; an open curve's end belongs to the last chord.
    const auto after = std::upper_bound(travelled.begin(), travelled.end(), s);
    const int chord = std::min(static_cast<int>(after - travelled.begin()) - 1, chords - 1);
    const double part = (s - travelled[chord]) / (travelled[chord + 1] - travelled[chord]);
    result.points.col(i) = curve(from + (to - from) * (chord + part) / chords);
  }
  return result;
}

}  // namespace tencer::geometry
