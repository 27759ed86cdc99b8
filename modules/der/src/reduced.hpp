// The elements of a rod whose section is isotropic and which is straight at rest: stretching of an
// edge and bending at a vertex as functions of positions alone (Bergou et al. 2008).
// Templated on the scalar so that the same gradient, in hyper-dual numbers, gives third
// derivatives.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "corner.hpp"

namespace tencer::der {

// E = EA / (2 l) (|e| - l)^2 of an edge vector e with rest length l.
template <class T>
T stretch_energy(double EA, double l, const Vector3<T>& e) {
  const T strain = e.norm() - l;
  return EA / (2 * l) * strain * strain;
}

template <class T>
Vector3<T> stretch_gradient(double EA, double l, const Vector3<T>& e) {
  using std::sqrt;
  const T length = sqrt(e.squaredNorm());
  return e * (EA * (length / l - 1.0) / length);
}

// d2E/de2 with the axial force N in the geometric part.
inline Eigen::Matrix3d stretch_hessian(double EA, double l, double N, const Eigen::Vector3d& e) {
  const double length = e.norm();
  const Eigen::Vector3d t = e / length;
  return (EA / l - N / length) * t * t.transpose() + N / length * Eigen::Matrix3d::Identity();
}

// E = EI / (2 v) |kb|^2 = 2 EI / v (1 - c) / (1 + c), c the cosine of the turning angle between the
// edges e and f, v the Voronoi length. Infinite for a fold (c = -1). 1 -+ c are taken from t -+ u,
// which keeps their digits for straight and folded vertices.
inline double bend_energy(double EI, double v, const Eigen::Vector3d& e, const Eigen::Vector3d& f) {
  const Eigen::Vector3d t = e.normalized();
  const Eigen::Vector3d u = f.normalized();
  const double fold = (t + u).squaredNorm();
  if (!(fold > 0)) return std::numeric_limits<double>::infinity();
  return 2 * EI / v * (t - u).squaredNorm() / fold;
}

template <class T>
struct BendGradient {
  Vector3<T> e, f;
};

template <class T>
BendGradient<T> bend_gradient(double EI, double v, const Vector3<T>& e, const Vector3<T>& f) {
  using std::sqrt;
  const T e_length = sqrt(e.squaredNorm());
  const T f_length = sqrt(f.squaredNorm());
  const Vector3<T> t = e / e_length;
  const Vector3<T> u = f / f_length;
  const Vector3<T> sum = t + u;
  const T fold = sum.squaredNorm() / 2.0;         // 1 + c
  const T slope = -4.0 * EI / v / (fold * fold);  // dE/dc
  // dc/de = u - c t and dc/df = t - c u, over the lengths; taken from t + u they are perpendicular
  // to t and u to all digits also in a fold, where what is left along an edge would be a force as
  // large as the edge's own.
  return {(sum - t * t.dot(sum)) * (slope / e_length), (sum - u * u.dot(sum)) * (slope / f_length)};
}

// d2E/d(e,f)2, 6 x 6.
inline Eigen::Matrix<double, 6, 6> bend_hessian(double EI, double v, const Eigen::Vector3d& e,
                                                const Eigen::Vector3d& f) {
  const double e_length = e.norm();
  const double f_length = f.norm();
  const Eigen::Vector3d t = e / e_length;
  const Eigen::Vector3d u = f / f_length;
  const double fold = (t + u).squaredNorm() / 2;
  const double c = fold - 1;
  const double slope = -4 * EI / v / (fold * fold);
  const double curvature = -2 * slope / fold;
  const Eigen::Vector3d p = u - c * t;
  const Eigen::Vector3d q = t - c * u;
  const Eigen::Matrix3d across_t = Eigen::Matrix3d::Identity() - t * t.transpose();
  const Eigen::Matrix3d across_u = Eigen::Matrix3d::Identity() - u * u.transpose();
  Eigen::Matrix<double, 6, 1> dc;
  dc << p / e_length, q / f_length;
  Eigen::Matrix<double, 6, 6> hessian = curvature * dc * dc.transpose();
  const Eigen::Matrix3d tp = t * p.transpose();
  const Eigen::Matrix3d uq = u * q.transpose();
  hessian.topLeftCorner<3, 3>() -=
      slope / (e_length * e_length) * (tp + tp.transpose() + c * across_t);
  hessian.bottomRightCorner<3, 3>() -=
      slope / (f_length * f_length) * (uq + uq.transpose() + c * across_u);
  const Eigen::Matrix3d mixed = slope / (e_length * f_length) * (across_t * across_u);
  hessian.topRightCorner<3, 3>() += mixed;
  hessian.bottomLeftCorner<3, 3>() += mixed.transpose();
  return hessian;
}

}  // namespace tencer::der
