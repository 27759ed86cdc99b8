// Positions along a polyline by arc length: wrapping on closed curves and location of a point in
// its edge (paper section 4, eq. 2).
#pragma once

#include <Eigen/Core>

namespace tencer::geometry {

// At a vertex the point belongs to two edges: `after` picks the edge that starts there, `before`
// the one that ends there. Elsewhere the side makes no difference.
enum class Side { after, before };

// a(s) = (1 - t) x_edge + t x_next, t in [0, 1], next = edge + 1 (0 at the seam).
struct Location {
  int edge = 0;
  double t = 0.0;
};

// The arc-length positions gamma_i of a polyline's vertices, from its edge lengths at rest, in
// their unit.
class ArcLength {
 public:
  // edge_lengths: n for a closed curve of n vertices, n-1 for an open one. Throws
  // std::invalid_argument unless all are positive and finite, and there is one.
  ArcLength(const Eigen::VectorXd& edge_lengths, bool closed);

  double length() const { return knots_[knots_.size() - 1]; }
  bool closed() const { return closed_; }
  int edges() const { return static_cast<int>(knots_.size()) - 1; }
  const Eigen::VectorXd& knots() const { return knots_; }  // edges + 1, from 0 to length()
  double edge_length(int edge) const { return knots_[edge + 1] - knots_[edge]; }

  // Closed: the representative of s modulo length() in [0, length()), exactly periodic, also for
  // negative s, for multiples of the length, and just below it. Open: s clamped to [0, length()].
  // This and locate throw std::invalid_argument for an s that is not finite.
  double wrap(double s) const;

  // The edge and parameter of the point at s (wrapped first).
  Location locate(double s, Side side = Side::after) const;

 private:
  Eigen::VectorXd knots_;
  bool closed_;
};

}  // namespace tencer::geometry
