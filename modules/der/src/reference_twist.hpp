// How the reference twist at a bending vertex, the angle from the director before it (carried
// across by parallel transport) to the director after it, changes with the edge vectors e and f
// when the directors follow their tangents by time-parallel transport (Bergou et al. 2010). On a
// closed rod the sum of these changes is minus the change of holonomy.
#pragma once

#include <Eigen/Geometry>

#include "corner.hpp"

namespace tencer::der {

template <class T>
struct TwistGradient {
  Vector3<T> e, f;
};

// t, u: unit vectors along e and f.
template <class T>
TwistGradient<T> twist_gradient(const Vector3<T>& t, const Vector3<T>& u, const T& e_length,
                                const T& f_length) {
  const Vector3<T> half_kb = t.cross(u) * (2.0 / (t + u).squaredNorm());
  return {half_kb / e_length, half_kb / f_length};
}

// d2(twist)/d(e,f)2 along straight motions of e and f, 6 x 6.
inline Eigen::Matrix<double, 6, 6> twist_hessian(const Eigen::Vector3d& t, const Eigen::Vector3d& u,
                                                 double e_length, double f_length) {
  const double fold = (t + u).squaredNorm() / 2;  // 1 + cosine of the turning angle
  const Eigen::Vector3d kb = t.cross(u) * (2 / fold);
  const Eigen::Vector3d middle = (t + u) / fold;
  const Eigen::Matrix3d ee = kb * (t + middle).transpose() / (-4 * e_length * e_length);
  const Eigen::Matrix3d ff = kb * (u + middle).transpose() / (-4 * f_length * f_length);
  const Eigen::Vector3d axis = t * (2 / fold);
  Eigen::Matrix3d ef = -kb * middle.transpose();
  ef(0, 1) -= axis.z();
  ef(0, 2) += axis.y();
  ef(1, 0) += axis.z();
  ef(1, 2) -= axis.x();
  ef(2, 0) -= axis.y();
  ef(2, 1) += axis.x();
  ef /= 2 * e_length * f_length;
  Eigen::Matrix<double, 6, 6> hessian;
  hessian << ee + ee.transpose(), ef, ef.transpose(), ff + ff.transpose();
  return hessian;
}

}  // namespace tencer::der
