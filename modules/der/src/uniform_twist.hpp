// Uniform twist of a closed rod: E = GJ / (2 L) (excess)^2 with excess = closing angle - holonomy -
// the rest twist, which is what is left of the sum over vertices of GJ / (2 v) twist^2 once the
// angles have come to rest.
#pragma once

#include <cmath>

#include "reference_twist.hpp"

namespace tencer::der {

inline double uniform_excess(const Rod& rod, const RodState& state) {
  return rod.closing_angle.value_or(0.0) - state.holonomy - rod.rest_twist.sum();
}

inline double twisting_moment(const Rod& rod, const RodState& state) {
  return rod.section.GJ / rod.length() * uniform_excess(rod, state);
}

// Of the excess, per bending vertex, with respect to its edge vectors.
template <class T>
TwistGradient<T> excess_gradient(const Vector3<T>& e, const Vector3<T>& f) {
  using std::sqrt;
  const T e_length = sqrt(e.squaredNorm());
  const T f_length = sqrt(f.squaredNorm());
  return twist_gradient<T>(e / e_length, f / f_length, e_length, f_length);
}

inline Eigen::Matrix<double, 6, 6> excess_hessian(const Eigen::Vector3d& e,
                                                  const Eigen::Vector3d& f) {
  return twist_hessian(e.normalized(), f.normalized(), e.norm(), f.norm());
}

}  // namespace tencer::der
