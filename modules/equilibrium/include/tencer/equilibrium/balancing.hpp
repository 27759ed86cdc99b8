// Tensions of inextensible cables at a state that may be out of balance.
#pragma once

#include <Eigen/Core>
#include <tencer/model/state.hpp>

namespace tencer::equilibrium {

// The tensions, >= 0 and one per cable, that cables of their rest_length have once the rods, to
// first order, have moved to where they balance: the convex quadratic program of the rods' Hessian,
// made positive definite, in which no cable gets longer than its length. Cables that do the same
// share their tension. Zeros where the Hessian is not finite.
Eigen::VectorXd balancing_tensions(const model::Structure& structure, const model::State& state);

}  // namespace tencer::equilibrium
