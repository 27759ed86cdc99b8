// What cables that pull with given tensions do at a state, whatever their law.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <tencer/equilibrium/system.hpp>
#include <vector>

namespace tencer::equilibrium {

// The distance between every cable's ends.
Eigen::VectorXd cable_lengths(const System& system, const model::State& state);

// The gradient of the rods' energy and loads plus what cables of these tensions, one each, exert.
Eigen::VectorXd gradient_with(const System& system, const model::State& state,
                              const Eigen::VectorXd& tensions);

// As stiff as the stiffest rod is along its axis.
double axial_stiffness(const model::Structure& structure);

// The cables as springs of this stiffness that pull with `tensions` at their lengths; none when
// that needs a rest length that is not positive.
std::optional<std::vector<springs::Cable>> as_springs(const model::Structure& structure,
                                                      const Eigen::VectorXd& tensions,
                                                      double stiffness);

}  // namespace tencer::equilibrium
