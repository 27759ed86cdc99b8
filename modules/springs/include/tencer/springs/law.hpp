// A cable's energy as a function of its span d, and the derivatives in d (paper eq. 3). Units are
// the structure's length and force; those in stiffness and rest length are in derivatives.hpp.
#pragma once

#include <Eigen/Core>
#include <tencer/springs/cable.hpp>

namespace tencer::springs {

// k (length - l), or 0 where a tension-only cable is slack.
double tension(const Cable& cable, double length);

// k/2 (length - l)^2, or 0 where slack.
double energy(const Cable& cable, double length);

// dE/dd: the force vector tension * d / |d|. At d = 0, where the direction is not defined, it is
// k d for l = 0 and zero otherwise.
Eigen::Vector3d force(const Cable& cable, const Eigen::Vector3d& d);

// d2E/dd2 = k t t^T + tension / |d| (I - t t^T); zero where slack. `tension` is the cable's tension
// at |d|, or a prediction of it (see der::hessian).
Eigen::Matrix3d stiffness_matrix(const Cable& cable, const Eigen::Vector3d& d, double tension);

// A spring with the same tension at length `length` and rest length rest_ratio * length, rest_ratio
// in [0, 1): the same equilibrium with another stiffness (paper section 4, "Cables"). Throws
// std::invalid_argument unless length > 0 and rest_ratio is in its range.
Cable rebased(const Cable& cable, double length, double rest_ratio);

// `cable` as a spring that pulls with `tension` at this length, its rest length rest_ratio (in
// [0, 1)) times the length. Requires length > 0.
Cable with_tension(Cable cable, double length, double tension, double rest_ratio);

}  // namespace tencer::springs
