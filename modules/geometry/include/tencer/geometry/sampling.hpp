// Points along a polyline by arc length, and polylines from smooth curves.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/geometry/polyline.hpp>

namespace tencer::geometry {

// The arc-length positions of a polyline's own vertices. Throws std::invalid_argument unless all
// edges have a positive finite length.
ArcLength arc_length(const Polyline& curve);

// The point at arc length s, wrapped (closed) or clamped (open). `arc` belongs to the same curve,
// at rest or as it is: the point divides its edge in the same proportion (paper eq. 2). Throws
// std::invalid_argument unless both have as many edges and s is finite.
Eigen::Vector3d point_at(const Polyline& curve, const ArcLength& arc, double s);

// n points at equal distances along the polyline, the first at vertex 0; an open one keeps its two
// ends. Throws std::invalid_argument unless n >= 3 (closed) or n >= 2 (open).
Polyline resample(const Polyline& curve, int n);

// The derivative in arc length at each vertex (3 x n, as points), of the parabola through it and
// its neighbours; at the ends of an open curve, of the parabola through the last three.
Eigen::Matrix3Xd slopes(const Eigen::Matrix3Xd& points, const ArcLength& arc);

// Points (3 x m) at these m arc lengths, wrapped or clamped, on the curve of cubics that has these
// slopes at the vertices (Hermite's); a smooth curve is met to fourth order in the edges. points:
// 3 x n, those that `arc` belongs to.
Eigen::Matrix3Xd smooth_points(const Eigen::Matrix3Xd& points, const ArcLength& arc,
                               const Eigen::VectorXd& at);

// A smooth curve by its parameter.
using Curve = std::function<Eigen::Vector3d(double)>;

// Arc length of a smooth curve over a parameter interval, to about 1e-10 relative for the built-in
// families.
double length(const Curve& curve, double from, double to);

// n points on the smooth curve at equal arc length, the first at parameter `from`. Closed: `to` is
// one period later and not repeated; open: the last point is at `to`. Throws std::invalid_argument
// unless n >= 3 (closed) or n >= 2 (open), and to > from.
Polyline sample(const Curve& curve, double from, double to, int n, bool closed);

}  // namespace tencer::geometry
