// How a structure vibrates about its pose: natural frequencies with the rods' own mass.
#pragma once

#include <Eigen/Core>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::certify {

struct [[nodiscard]] VibrationModes {
  // Ascending; 0 for a motion that costs nothing or that the structure gains energy by.
  Eigen::VectorXd hertz{};
  // Per mode, per rod, 3 x n: where the vertices move, the largest component 1.
  std::vector<std::vector<Eigen::Matrix3Xd>> shapes{};
  bool computed = false;  // false: the eigenvalue iteration failed
};

// The `count` lowest modes (fewer of a structure that has fewer) of K v = omega^2 M v on motions
// that keep the lengths of taut cables and are not rigid: K the Hessian of the Lagrangian, M the
// rods' mass lumped at their vertices; cables have none. Twist follows positions statically.
// tensions: per cable, as the equilibrium has them. mass_per_length: per rod, in the structure's
// force times second^2 per length^2. Throws std::invalid_argument for other sizes and for masses
// that are not positive.
VibrationModes vibration_modes(const model::Structure& structure, const model::State& state,
                               const Eigen::VectorXd& tensions,
                               const Eigen::VectorXd& mass_per_length, int count = 10);

}  // namespace tencer::certify
