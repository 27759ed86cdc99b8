// A curve as a chain of vertices, open or closed.
#pragma once

#include <Eigen/Core>

namespace tencer::geometry {

// More vertices than this on a curve are a mistake rather than a wish.
constexpr int max_vertices = 1'000'000;

// points: 3 x n, one column a vertex, in the units of the scene. A closed polyline does not repeat
// its first vertex: edge n-1 joins vertex n-1 to vertex 0.
struct Polyline {
  Eigen::Matrix3Xd points;
  bool closed = false;

  int vertices() const { return static_cast<int>(points.cols()); }
  int edges() const { return closed ? vertices() : vertices() - 1; }
};

// Edge vectors (3 x edges), each from its first vertex to the next, and their lengths (edges).
Eigen::Matrix3Xd edge_vectors(const Polyline& curve);
Eigen::VectorXd edge_lengths(const Polyline& curve);

}  // namespace tencer::geometry
