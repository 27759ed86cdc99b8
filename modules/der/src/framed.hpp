// Bending and twisting at a vertex with material frames (Bergou et al. 2008): each of the two edges
// sees the curvature in its own frame, so that theta drops out of the bending of an isotropic rod
// that is straight at rest.
//
// In the frame of an edge the curvature components are (kb . m2, -kb . m1). With the unit tangents
// t before and u after the vertex these are 2 (u . m1, u . m2) / (1 + t . u) for the edge before
// and -2 (t . m1, t . m2) / (1 + t . u) for the edge after: how far the rod turns towards m1 and
// towards m2. Turning towards m1 is bending about m2, hence resisted by EI2.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "reference_twist.hpp"

namespace tencer::der {

template <class T>
struct MaterialFrame {
  Vector3<T> m1, m2;
};

template <class T>
MaterialFrame<T> material_frame(const Vector3<T>& tangent, const Vector3<T>& director,
                                const T& theta) {
  using std::cos;
  using std::sin;
  const T c = cos(theta);
  const T s = sin(theta);
  const Vector3<T> across = tangent.cross(director);
  return {director * c + across * s, across * c - director * s};
}

// The vertex as deformed. twist: from the frame before to the frame after, radians.
template <class T>
struct FramedVertex {
  Vector3<T> t, u;
  T e_length, f_length;
  MaterialFrame<T> before, after;
  T twist;
};

// What acts there. Energy sum_j |w_j - rest_j|^2 weighted by bend / 2, over both edges j, plus
// twist_stiffness / 2 (twist - rest_twist)^2.
struct VertexLaw {
  Eigen::Vector2d bend;                   // (EI2, EI1) / (2 v)
  Eigen::Vector2d rest_before{0.0, 0.0};  // rest curvature in the frame of the edge before
  Eigen::Vector2d rest_after{0.0, 0.0};   // and of the edge after
  double twist_stiffness = 0, rest_twist = 0;
};

// Curvature components in the two frames, and 1 + t . u.
template <class T>
struct VertexCurvature {
  Eigen::Matrix<T, 2, 1> before, after;
  T fold;
};

template <class T>
VertexCurvature<T> vertex_curvature(const FramedVertex<T>& v) {
  const T fold = (v.t + v.u).squaredNorm() / 2.0;
  const T factor = 2.0 / fold;
  VertexCurvature<T> w;
  w.before << v.u.dot(v.before.m1) * factor, v.u.dot(v.before.m2) * factor;
  w.after << -(v.t.dot(v.after.m1) * factor), -(v.t.dot(v.after.m2) * factor);
  w.fold = fold;
  return w;
}

inline double framed_energy(const VertexLaw& law, const FramedVertex<double>& v) {
  const auto w = vertex_curvature(v);
  if (!(w.fold > 0)) return std::numeric_limits<double>::infinity();
  const Eigen::Array2d before = w.before - law.rest_before;
  const Eigen::Array2d after = w.after - law.rest_after;
  const double excess = v.twist - law.rest_twist;
  return (law.bend.array() * (before.square() + after.square())).sum() / 2 +
         law.twist_stiffness * excess * excess / 2;
}

template <class T>
struct FramedGradient {
  Vector3<T> e, f;
  T theta_before, theta_after;
};

// At frames carried here by time-parallel transport: see energy.hpp, displace.
template <class T>
FramedGradient<T> framed_gradient(const VertexLaw& law, const FramedVertex<T>& v) {
  const auto w = vertex_curvature(v);
  const T c = w.fold - 1.0;
  // Bending moments, and the vectors M, N with energy change = moments . change of curvature =
  // d (2 (u . M - t . N) / fold) for M, N fixed in the frames before and after.
  Eigen::Matrix<T, 2, 1> before, after;
  for (int i = 0; i < 2; ++i) {
    before[i] = (w.before[i] - law.rest_before[i]) * law.bend[i];
    after[i] = (w.after[i] - law.rest_after[i]) * law.bend[i];
  }
  const Vector3<T> M = v.before.m1 * before[0] + v.before.m2 * before[1];
  const Vector3<T> N = v.after.m1 * after[0] + v.after.m2 * after[1];
  const T uM = v.u.dot(M);
  const T tN = v.t.dot(N);
  const T half_fold = w.fold / 2.0;
  const T half_F = (uM - tN) / w.fold;
  const T pull = (v.twist - law.rest_twist) * law.twist_stiffness;
  const auto twist = twist_gradient<T>(v.t, v.u, v.e_length, v.f_length);
  const Vector3<T> e = v.t * tN - N - M * c - (v.u - v.t * c) * half_F;
  const Vector3<T> f = M - v.u * uM + N * c - (v.t - v.u * c) * half_F;
  FramedGradient<T> g;
  g.e = e / (v.e_length * half_fold) + twist.e * pull;
  g.f = f / (v.f_length * half_fold) + twist.f * pull;
  g.theta_before = before[0] * w.before[1] - before[1] * w.before[0] - pull;
  g.theta_after = after[0] * w.after[1] - after[1] * w.after[0] + pull;
  return g;
}

// d2E/d(e, f, theta_before, theta_after)2 along the motions of energy.hpp, displace.
inline Eigen::Matrix<double, 8, 8> framed_hessian(const VertexLaw& law,
                                                  const FramedVertex<double>& v) {
  using Vector8 = Eigen::Matrix<double, 8, 1>;
  const auto w = vertex_curvature(v);
  const double c = w.fold - 1;
  const Eigen::Vector3d& t = v.t;
  const Eigen::Vector3d& u = v.u;
  const Eigen::Vector3d p = u - c * t;
  const Eigen::Vector3d q = t - c * u;
  // All in (|e| e, |f| f, theta, theta) first: lengths are divided out at the end.
  Vector8 dc;
  dc << p, q, 0, 0;

  Eigen::Matrix<double, 8, 8> h = Eigen::Matrix<double, 8, 8>::Zero();
  const auto stiffness_along = [&](double stiffness, const Vector8& dw) {
    h.noalias() += (stiffness * dw) * dw.transpose();
  };
  const auto before_component = [&](int i, const Eigen::Vector3d& m, double turned) {
    const double a = u.dot(m);
    Vector8 da;
    da << -c * m, m - a * u, turned, 0;
    stiffness_along(law.bend[i], (2 * da - w.before[i] * dc) / w.fold);
  };
  before_component(0, v.before.m1, u.dot(v.before.m2));
  before_component(1, v.before.m2, -u.dot(v.before.m1));
  const auto after_component = [&](int i, const Eigen::Vector3d& m, double turned) {
    const double a = t.dot(m);
    Vector8 da;
    da << m - a * t, -c * m, 0, turned;
    stiffness_along(law.bend[i], (-2 * da - w.after[i] * dc) / w.fold);
  };
  after_component(0, v.after.m1, t.dot(v.after.m2));
  after_component(1, v.after.m2, -t.dot(v.after.m1));

  // Moments times second derivatives of the curvature: F = 2 Q / fold, Q = u . M - t . N. M1, N1:
  // the change of M, N with theta.
  const Eigen::Array2d before = law.bend.array() * (w.before - law.rest_before).array();
  const Eigen::Array2d after = law.bend.array() * (w.after - law.rest_after).array();
  const Eigen::Vector3d M = before[0] * v.before.m1 + before[1] * v.before.m2;
  const Eigen::Vector3d M1 = before[0] * v.before.m2 - before[1] * v.before.m1;
  const Eigen::Vector3d N = after[0] * v.after.m1 + after[1] * v.after.m2;
  const Eigen::Vector3d N1 = after[0] * v.after.m2 - after[1] * v.after.m1;
  const double uM = u.dot(M);
  const double tN = t.dot(N);
  const double F = 2 * (uM - tN) / w.fold;
  Vector8 dQ;
  dQ << tN * t - N - c * M, M - uM * u + c * N, u.dot(M1), -t.dot(N1);
  const Vector8 dF = (2 * dQ - F * dc) / w.fold;
  h.noalias() -= dF * (dc / w.fold).transpose();
  h.noalias() -= (dc / w.fold) * dF.transpose();

  const double q2 = 2 / w.fold;
  const double c2 = F / w.fold;
  const Eigen::Vector3d n = N - tN * t;
  const Eigen::Vector3d k = M - uM * u;
  const Eigen::Matrix3d across_t = Eigen::Matrix3d::Identity() - t * t.transpose();
  const Eigen::Matrix3d across_u = Eigen::Matrix3d::Identity() - u * u.transpose();
  // Symmetric blocks as half + half^T.
  const Eigen::Matrix3d ee = t * (q2 * (c * M + n) + c2 * p).transpose() -
                             (q2 / 2) * M * p.transpose() + ((q2 * tN + c2 * c) / 2) * across_t;
  const Eigen::Matrix3d ff = u * (c2 * q - q2 * (k + c * N)).transpose() +
                             (q2 / 2) * N * q.transpose() + ((c2 * c - q2 * uM) / 2) * across_u;
  const Eigen::Matrix3d ef =
      q2 * (p * N.transpose() - M * q.transpose()) - c2 * (across_t * across_u);
  h.block<3, 3>(0, 0) += ee + ee.transpose();
  h.block<3, 3>(3, 3) += ff + ff.transpose();
  h.block<3, 3>(0, 3) += ef;
  h.block<3, 3>(3, 0) += ef.transpose();
  Eigen::Matrix<double, 6, 2> turn;
  turn.col(0) << -q2 * c * M1, q2 * (M1 - u.dot(M1) * u);
  turn.col(1) << q2 * (t.dot(N1) * t - N1), q2 * c * N1;
  h.topRightCorner<6, 2>() += turn;
  h.bottomLeftCorner<2, 6>() += turn.transpose();
  h(6, 6) -= q2 * uM;
  h(7, 7) += q2 * tN;

  h.leftCols<3>() /= v.e_length;
  h.topRows<3>() /= v.e_length;
  h.middleCols<3>(3) /= v.f_length;
  h.middleRows<3>(3) /= v.f_length;

  if (law.twist_stiffness > 0) {
    const auto twist = twist_gradient<double>(t, u, v.e_length, v.f_length);
    Vector8 d;
    d << twist.e, twist.f, -1, 1;
    stiffness_along(law.twist_stiffness, d);
    h.topLeftCorner<6, 6>() += law.twist_stiffness * (v.twist - law.rest_twist) *
                               twist_hessian(t, u, v.e_length, v.f_length);
  }
  return h;
}

}  // namespace tencer::der
