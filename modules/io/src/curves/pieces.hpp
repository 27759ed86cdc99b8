// Smooth pieces of drawn curves - lines, arcs, Bezier curves, splines - and the points along them
// that a rod is given.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

namespace tencer::io {

struct Piece {
  std::function<Eigen::Vector3d(double)> at;  // from t = 0 to 1
  bool straight = false;

  Eigen::Vector3d from() const { return at(0); }
  Eigen::Vector3d to() const { return at(1); }
};

Piece line(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
Piece bezier(std::vector<Eigen::Vector3d> control);  // of any degree from 1

// center + cos(angle) * x + sin(angle) * y, from angle `start` on by `sweep`, in radians.
Piece arc(const Eigen::Vector3d& center, const Eigen::Vector3d& x, const Eigen::Vector3d& y,
          double start, double sweep);

// The same the other way.
Piece reversed(Piece piece);

// A rational B-spline of its control points (3 x n), their weights (n, or none: all 1) and knots (n
// + degree + 1, not decreasing), between these parameters, as far as it is defined there.
struct Nurbs {
  int degree = 3;
  Eigen::Matrix3Xd control{};
  Eigen::VectorXd weights{};
  std::vector<double> knots{};
  double from = 0.0;
  double to = 1.0;
};

// Why a spline cannot be drawn, in words; nullptr: it can.
const char* problem(const Nurbs& spline);

// Its spans, one after the other: each is smooth. The spline has no problem.
std::vector<Piece> pieces(const Nurbs& spline);

// Points along pieces of which each begins where the one before ends: both ends of every piece
// and, where any piece is not straight, points between them, evenly spaced and close enough that
// the polygon turns by 0.1 radians at most, but not more than about a thousand in all.
std::vector<Eigen::Vector3d> points_along(std::span<const Piece> pieces);

}  // namespace tencer::io
