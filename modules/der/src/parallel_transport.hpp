// Parallel transport between unit tangents, in space or in time, and signed angles about them.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace tencer::der {

// d, perpendicular to t, turned by the smallest rotation that takes t to u. Where that is not
// unique (u = -t), d itself.
inline Eigen::Vector3d parallel_transport(const Eigen::Vector3d& d, const Eigen::Vector3d& t,
                                          const Eigen::Vector3d& u) {
  const Eigen::Vector3d sum = t + u;
  const double fold = sum.squaredNorm() / 2;
  if (!(fold > 0)) return d;
  return d - d.dot(u) / fold * sum;
}

// d made exactly perpendicular to t and of unit length, which repeated transport loses slowly.
inline Eigen::Vector3d director(const Eigen::Vector3d& d, const Eigen::Vector3d& t) {
  return (d - d.dot(t) * t).normalized();
}

// From a to b about t, in [-pi, pi].
inline double signed_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                           const Eigen::Vector3d& t) {
  return std::atan2(t.dot(a.cross(b)), a.dot(b));
}

}  // namespace tencer::der
