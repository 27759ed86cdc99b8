// Numbers a + b e1 + c e2 + d e1 e2 with e1^2 = e2^2 = 0: a function evaluated in them gives its
// value, two directional derivatives and the mixed second one, exactly.
#pragma once

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

namespace tencer::der {

using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
using HyperDual = Eigen::AutoDiffScalar<Eigen::Matrix<Dual, 1, 1>>;

// x + e1 v + e2 w, component by component.
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

// The coefficients of e1 e2.
inline Eigen::Vector3d mixed_part(const Eigen::Matrix<HyperDual, 3, 1>& values) {
  Eigen::Vector3d result;
  for (int i = 0; i < 3; ++i) result[i] = values[i].derivatives()[0].derivatives()[0];
  return result;
}

}  // namespace tencer::der
