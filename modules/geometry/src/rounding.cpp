#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tencer/core/error.hpp>
#include <tencer/geometry/rounding.hpp>
#include <tencer/geometry/sampling.hpp>

namespace tencer::geometry {
namespace {

using Eigen::Vector3d;

constexpr int bend_pieces = 48;  // of a bend

// A cubic by the ends of its legs.
struct Bend {
  std::array<Vector3d, 4> legs{};

  Vector3d at(double t) const {
    const double u = 1 - t;
    return u * u * u * legs[0] + 3 * u * u * t * legs[1] + 3 * u * t * t * legs[2] +
           t * t * t * legs[3];
  }

  double least_radius() const {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= bend_pieces; ++i) {
      const double t = double(i) / bend_pieces;
      const double u = 1 - t;
      const Vector3d first = 3 * (u * u * (legs[1] - legs[0]) + 2 * u * t * (legs[2] - legs[1]) +
                                  t * t * (legs[3] - legs[2]));
      const Vector3d second =
          6 * (u * (legs[2] - 2 * legs[1] + legs[0]) + t * (legs[3] - 2 * legs[2] + legs[1]));
      const double speed = first.norm();
      const double turning = first.cross(second).norm();
      // Where it stands still it turns on the spot.
      least = std::min(least, speed > 0 ? speed * speed * speed / turning : 0.0);
    }
    return least;
  }
};

// A part of a curve that is to be replaced, by arc length; on a closed curve `from` may be negative
// and `to` beyond the length.
struct Stretch {
  double from = 0.0;
  double to = 0.0;
  Corner sharpest{};
  double turn = 0.0;    // of the sharpest vertex
  double before = 0.0;  // where the bend begins
  double after = 0.0;   // and where it ends
  Bend bend{};
};

class Rounding {
 public:
  Rounding(const Polyline& curve, double radius)
      : curve_(curve), radius_(radius), arc_(arc_length(curve)), edges_(edge_vectors(curve)) {}

  Rounded round() {
    Rounded result{.curve = curve_};
    std::vector<Stretch> stretches = sharp_stretches();
    if (stretches.empty()) return result;
    for (Stretch& stretch : stretches)
      if (!find_bend(stretch)) return without_room(stretch);
    while (const auto merged = merge_two(stretches))
      if (!find_bend(stretches[*merged])) return without_room(stretches[*merged]);
    for (const Stretch& stretch : stretches) {
      result.bends.push_back(stretch.sharpest);
      result.largest_move = std::max(result.largest_move, move_of(stretch));
    }
    result.curve = with_bends(stretches);
    return result;
  }

 private:
  double length() const { return arc_.length(); }

  Rounded without_room(const Stretch& stretch) const {
    return {.curve = curve_, .no_room = stretch.sharpest};
  }

  // One a vertex, or several that straight edges of this length leave no room for.
  std::vector<Stretch> sharp_stretches() const {
    constexpr double slack = 0.99;  // a curve sampled from an arc of this radius is fine
    const std::vector<Corner> sharp = corners(curve_);
    const int n = curve_.edges();
    std::vector<Stretch> stretches;
    double last_reach = 0;
    for (int v = curve_.closed ? 0 : 1; v < n; ++v) {
      const int before = (v + n - 1) % n;
      const Vector3d a = edges_.col(before);
      const Vector3d b = edges_.col(v);
      const double turn = std::atan2(a.cross(b).norm(), a.dot(b));
      // Of the edges, the part in which a curve would turn: about half of each, of a long one less.
      const double along = std::min(a.norm() + b.norm(), 3 * std::min(a.norm(), b.norm())) / 2;
      const bool corner = std::ranges::find(sharp, v, &Corner::vertex) != sharp.end();
      if (!corner && 2 * std::tan(turn / 2) * slack * radius_ <= along) continue;
      const double s = arc_.knots()[v];
      const Stretch one{
          .from = s, .to = s, .sharpest = {.vertex = v, .s = s, .angle = turn}, .turn = turn};
      const double reach = radius_ * std::tan(turn / 2);
      if (!stretches.empty() && s - stretches.back().to < reach + last_reach)
        join(stretches.back(), one);
      else
        stretches.push_back(one);
      last_reach = reach;
    }
    return stretches;
  }

  Vector3d tangent(double s, Side side) const {
    return edges_.col(arc_.locate(s, side).edge).normalized();
  }

  static void join(Stretch& one, const Stretch& next) {
    one.to = next.to;
    one.sharpest.angle += next.sharpest.angle;
    if (next.turn <= one.turn) return;
    one.turn = next.turn;
    one.sharpest.vertex = next.sharpest.vertex;
    one.sharpest.s = next.sharpest.s;
  }

  // From so far before a stretch to as far behind it.
  Bend bend_between(double before, double after) const {
    const Vector3d start = point_at(curve_, arc_, before);
    const Vector3d end = point_at(curve_, arc_, after);
    const Vector3d first = tangent(before, Side::before);
    const Vector3d last = tangent(after, Side::after);
    const double angle = std::atan2(first.cross(last).norm(), first.dot(last));
    // The legs of an arc, where it is one.
    const double share =
        angle > 1e-6 ? 2.0 / 3 * std::tan(angle / 4) / std::sin(angle / 2) : 1.0 / 3;
    const double leg = share * (end - start).norm();
    return {{start, start + leg * first, end - leg * last, end}};
  }

  // The shortest bend that is not too sharp; false: there is none.
  bool find_bend(Stretch& stretch) const {
    constexpr double first = 0.05;  // of the radius
    constexpr double growth = 1.02;
    constexpr double enough = 0.99;
    // One bend goes round no further than this.
    constexpr double farthest = 0.95 * std::numbers::pi;
    if (stretch.sharpest.angle > farthest) return false;
    for (double reach = first * radius_;; reach *= growth) {
      stretch.before = stretch.from - reach;
      stretch.after = stretch.to + reach;
      if (!curve_.closed && (stretch.before < 0 || stretch.after > length())) return false;
      if (stretch.after - stretch.before > length()) return false;
      stretch.bend = bend_between(stretch.before, stretch.after);
      if (stretch.bend.least_radius() >= enough * radius_) return true;
    }
  }

  // Puts two whose bends meet into one, whose bend is yet to be found; not set: there are none.
  std::optional<std::size_t> merge_two(std::vector<Stretch>& stretches) const {
    const std::size_t count = stretches.size();
    for (std::size_t i = 0; i < count && count > 1; ++i) {
      const bool over_seam = i + 1 == count;
      if (over_seam && !curve_.closed) break;
      Stretch next = stretches[(i + 1) % count];
      const double turn = over_seam ? length() : 0.0;
      if (stretches[i].after <= next.before + turn) continue;
      next.to += turn;
      join(stretches[i], next);
      stretches.erase(stretches.begin() + static_cast<std::ptrdiff_t>((i + 1) % count));
      return over_seam ? i - 1 : i;
    }
    return std::nullopt;
  }

  double move_of(const Stretch& stretch) const {
    double largest = 0;
    for (int v = 0; v < curve_.vertices(); ++v) {
      double s = arc_.knots()[v];
      while (curve_.closed && s < stretch.before) s += length();
      if (s < stretch.before || s > stretch.after) continue;
      double nearest = std::numeric_limits<double>::infinity();
      for (int i = 0; i <= bend_pieces; ++i)
        nearest = std::min(
            nearest, (stretch.bend.at(double(i) / bend_pieces) - curve_.points.col(v)).norm());
      largest = std::max(largest, nearest);
    }
    return largest;
  }

  // All around from the end of the last bend, on a closed curve; then from where it started.
  Polyline with_bends(const std::vector<Stretch>& stretches) const {
    std::vector<Vector3d> points;
    // Without repeating a point.
    const auto add = [&](const Vector3d& point) {
      constexpr double nothing = 1e-9;
      if (points.empty() || (point - points.back()).norm() > nothing * length())
        points.push_back(point);
    };
    const double start = curve_.closed ? stretches.back().after - length() : 0.0;
    double at = start;
    for (const Stretch& stretch : stretches) {
      add_vertices(at, stretch.before, add);
      for (int i = 0; i <= bend_pieces; ++i) add(stretch.bend.at(double(i) / bend_pieces));
      at = stretch.after;
    }
    if (!curve_.closed) {
      add_vertices(at, length(), add);
      add(curve_.points.rightCols<1>());
    } else if ((points.front() - points.back()).norm() <= 1e-9 * length()) {
      points.pop_back();
    }
    if (curve_.closed) {
      const auto first = std::ranges::min_element(points, {}, [&](const Vector3d& point) {
        return (point - curve_.points.col(0)).squaredNorm();
      });
      std::rotate(points.begin(), first, points.end());
    }
    Polyline result{Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(points.size())), curve_.closed};
    for (std::size_t i = 0; i < points.size(); ++i)
      result.points.col(static_cast<Eigen::Index>(i)) = points[i];
    return result;
  }

  // Those from one arc length on to before another.
  template <class Add>
  void add_vertices(double from, double to, Add&& add) const {
    for (int turn = curve_.closed ? -1 : 0; turn <= (curve_.closed ? 1 : 0); ++turn)
      for (int v = 0; v < curve_.vertices(); ++v) {
        const double s = arc_.knots()[v] + turn * length();
        if (s >= from && s < to) add(curve_.points.col(v));
      }
  }

  const Polyline& curve_;
  double radius_;
  ArcLength arc_;
  Eigen::Matrix3Xd edges_;
};

}  // namespace

Rounded rounded(const Polyline& curve, double radius) {
  core::require(radius > 0, "rounded: the radius is positive");
  return Rounding(curve, radius).round();
}

}  // namespace tencer::geometry
