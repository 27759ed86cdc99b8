// Which vertices and edges meet at a bending vertex, and how derivatives with respect to its two
// edge vectors become derivatives with respect to its three vertices.
#pragma once

#include <Eigen/Core>
#include <tencer/der/rod.hpp>

namespace tencer::der {

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;

inline int next(const Rod& rod, int vertex) { return vertex + 1 < rod.vertices() ? vertex + 1 : 0; }

// The vector of edge j, from vertex j to the next.
inline Eigen::Vector3d edge(const Rod& rod, const Eigen::Matrix3Xd& x, int j) {
  return x.col(next(rod, j)) - x.col(j);
}

struct Corner {
  int before, at, after;        // vertices
  int edge_before, edge_after;  // edges
  double voronoi;
};

inline Corner corner(const Rod& rod, int b) {
  const int at = rod.bending_vertex(b);
  const int before = at > 0 ? at - 1 : rod.vertices() - 1;
  return {before, at, next(rod, at),
          before, at, (rod.rest_lengths[before] + rod.rest_lengths[at]) / 2};
}

// The bending vertex between a closed rod's last edge and its first.
inline bool is_seam(const Rod& rod, int b) { return rod.closed && b == 0; }

// From a Hessian in (e, f, K more) to the one in (x_before, x_at, x_after, K more): e = x_at -
// x_before, f = x_after - x_at.
template <int K>
Eigen::Matrix<double, 9 + K, 9 + K> to_vertices(const Eigen::Matrix<double, 6 + K, 6 + K>& h) {
  Eigen::Matrix<double, 9 + K, 6 + K> half;  // rows: vertices
  half.template topRows<3>() = -h.template topRows<3>();
  half.template middleRows<3>(3) = h.template topRows<3>() - h.template middleRows<3>(3);
  half.template bottomRows<3 + K>() = h.template bottomRows<3 + K>();
  Eigen::Matrix<double, 9 + K, 9 + K> full;
  full.template leftCols<3>() = -half.template leftCols<3>();
  full.template middleCols<3>(3) = half.template leftCols<3>() - half.template middleCols<3>(3);
  full.template rightCols<3 + K>() = half.template rightCols<3 + K>();
  return full;
}

}  // namespace tencer::der
