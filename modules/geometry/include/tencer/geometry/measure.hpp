// Sizes of and distances between polylines.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <tencer/geometry/polyline.hpp>

namespace tencer::geometry {

// Diagonal of the axis-aligned bounding box of all vertices together, the length to which the paper
// relates its errors (table 1). 0 for no vertices.
double bounding_box_diagonal(std::span<const Polyline> curves);

// Closest points of the segments a0 a1 and b0 b1: (1 - t) p0 + t p1 on each, t in [0, 1].
struct SegmentApproach {
  double distance = 0.0;
  double t_a = 0.0;
  double t_b = 0.0;
};
SegmentApproach segment_approach(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1,
                                 const Eigen::Vector3d& b0, const Eigen::Vector3d& b1);

// A place on one of several curves: rod is the curve's index, t in [0, 1] along the edge.
struct EdgePoint {
  int rod = 0;
  int edge = 0;
  double t = 0.0;
};

struct Approach {
  EdgePoint a;
  EdgePoint b;
  double distance = 0.0;
};

// Where two edges that share no vertex come closest, on one curve or between two; distance 0 is a
// crossing. None when there is no such pair. Time grows with the square of the number of edges.
std::optional<Approach> closest_approach(std::span<const Polyline> curves);

}  // namespace tencer::geometry
