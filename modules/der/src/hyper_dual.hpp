// Numbers a + b e1 + c e2 + d e1 e2 with e1^2 = e2^2 = 0: a function evaluated in them gives its
// value, two directional derivatives and the mixed second one, exactly.
#pragma once

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

namespace tencer::der {

using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
using HyperDual = Eigen::AutoDiffScalar<Eigen::Matrix<Dual, 1, 1>>;

// x + e1 v + e2 w.
inline HyperDual hyper_dual(double x, double v, double w) {
  HyperDual result;
  result.value() = Dual(x, Eigen::Matrix<double, 1, 1>(v));
  result.derivatives()[0] = Dual(w, Eigen::Matrix<double, 1, 1>(0.0));
  return result;
}

inline Eigen::Matrix<HyperDual, 3, 1> hyper_dual_vector(const Eigen::Vector3d& x,
                                                        const Eigen::Vector3d& v,
                                                        const Eigen::Vector3d& w) {
  Eigen::Matrix<HyperDual, 3, 1> result;
  for (int i = 0; i < 3; ++i) {
    result[i].value() = Dual(x[i], Eigen::Matrix<double, 1, 1>(v[i]));
    result[i].derivatives()[0] = Dual(w[i], Eigen::Matrix<double, 1, 1>(0.0));
  }
  return result;
}

// The coefficients of e1 e2, and of e1.
inline double mixed_part(const HyperDual& value) { return value.derivatives()[0].derivatives()[0]; }

inline Eigen::Vector3d mixed_part(const Eigen::Matrix<HyperDual, 3, 1>& values) {
  return {mixed_part(values[0]), mixed_part(values[1]), mixed_part(values[2])};
}

inline Eigen::Vector3d first_part(const Eigen::Matrix<HyperDual, 3, 1>& values) {
  return {values[0].value().derivatives()[0], values[1].value().derivatives()[0],
          values[2].value().derivatives()[0]};
}

}  // namespace tencer::der
