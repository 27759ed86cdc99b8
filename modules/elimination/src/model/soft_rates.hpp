// How the softest eigenvalues change with a network's variables.
#pragma once

#include <Eigen/Core>
#include <tencer/equilibrium/modal.hpp>

#include "model/local_model.hpp"

namespace tencer::elimination {

// d(value)/dz (Z) of mode k, exact: the derivative of the Hessian along the mode, with the shape
// following the variables.
Eigen::VectorXd soft_rates(const sensitivity::Configuration& at, const equilibrium::SoftModes& soft,
                           Eigen::Index k, const LocalModel& local);

}  // namespace tencer::elimination
