// What cables that pull with given tensions do at a state, whatever their law.
#pragma once

#include <Eigen/Core>
#include <tencer/equilibrium/system.hpp>

namespace tencer::equilibrium {

// The distance between every cable's ends.
Eigen::VectorXd cable_lengths(const System& system, const model::State& state);

// The gradient of the rods' energy and loads plus what cables of these tensions, one each, exert.
Eigen::VectorXd gradient_with(const System& system, const model::State& state,
                              const Eigen::VectorXd& tensions);

// As stiff as the stiffest rod is along its axis.
double axial_stiffness(const model::Structure& structure);

}  // namespace tencer::equilibrium
