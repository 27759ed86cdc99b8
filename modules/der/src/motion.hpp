// A rod on its way along a v + b w, in hyper-dual numbers, for third derivatives.
#pragma once

#include <Eigen/Core>

#include "corner.hpp"
#include "hyper_dual.hpp"

namespace tencer::der {

using HyperVector = Vector3<HyperDual>;

struct Motion {
  const Rod& rod;
  const RodState& state;
  const Eigen::VectorXd& v;
  const Eigen::VectorXd& w;

  Eigen::Vector3d difference(const Eigen::VectorXd& a, int j) const {
    return a.segment<3>(3 * next(rod, j)) - a.segment<3>(3 * j);
  }
  HyperVector along(int j) const {
    return hyper_dual_vector(edge(rod, state.x, j), difference(v, j), difference(w, j));
  }
};

inline void add_to_vertices(const Corner& c, const Eigen::Vector3d& e, const Eigen::Vector3d& f,
                            Eigen::VectorXd& result) {
  result.segment<3>(3 * c.before) -= e;
  result.segment<3>(3 * c.at) += e - f;
  result.segment<3>(3 * c.after) += f;
}

// The part of bending and twisting with material frames.
void add_framed_third_derivative(const Motion& motion, Eigen::VectorXd& result);

}  // namespace tencer::der
