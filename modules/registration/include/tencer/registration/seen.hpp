// Rigid registration where a distance d counts as d^T M d: what is seen of it from some side, say.
// M is a 3 x 3 symmetric positive semidefinite matrix, not zero, in the frame of the set that is
// moved. Unlike for M = 1 the best rotation has no closed form.
#pragma once

#include <Eigen/Core>
#include <tencer/registration/rigid.hpp>

namespace tencer::registration {

// A proper rigid motion at which sum_i w_i |motion(from_i) - to_i|_M^2 is least among those nearby:
// Newton's method from align(), the best for M = 1. Centres coincide, also where M does not ask for
// it. Sizes and errors as of align(); std::invalid_argument as well for an M that is not finite.
RigidMotion align_seen(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                       const Eigen::VectorXd& weights, const Eigen::Matrix3d& metric);

// Half the second derivative of that sum in turns of `to` about its centre: arms (3 x n) from
// there, `away` (3 x n) to each of `to` from where `from` has come, the metric in the frame of both
// as they are now.
Eigen::Matrix3d turning_stiffness(const Eigen::Matrix3Xd& arms, const Eigen::Matrix3Xd& away,
                                  const Eigen::VectorXd& weights, const Eigen::Matrix3d& metric);

}  // namespace tencer::registration
