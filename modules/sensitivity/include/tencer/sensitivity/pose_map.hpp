// The map from cables' parameters to the pose x*(p), for functions of the pose that others compute:
// its derivative forwards and backwards, as frameworks with derivatives of their own take it.
#pragma once

#include <Eigen/Core>
#include <span>
#include <tencer/sensitivity/tracker.hpp>
#include <tencer/springs/parameter.hpp>
#include <vector>

namespace tencer::sensitivity {

// dF/dp (P) of any F(x*) from dF/dx at the vertices (3 x n per rod): one adjoint solve. What F
// feels of rigid motions that supports leave free does not count: the pose has none. Throws
// std::invalid_argument when sizes do not fit.
Eigen::VectorXd pull_back(const Configuration& at, std::span<const springs::Parameter> parameters,
                          const std::vector<Eigen::Matrix3Xd>& gradient);

// How the vertices move (3 x n per rod) with parameters that change by `change` (P), without rigid
// motion; one solve. Throws likewise.
std::vector<Eigen::Matrix3Xd> push_forward(const Configuration& at,
                                           std::span<const springs::Parameter> parameters,
                                           const Eigen::VectorXd& change);

}  // namespace tencer::sensitivity
