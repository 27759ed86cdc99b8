// The equilibrium next to a state, stable or not.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <tencer/equilibrium/system.hpp>

namespace tencer::equilibrium {

struct Stationary {
  model::State state{};
  Eigen::VectorXd tensions{};  // per cable; 0 of slack ones
  // In so many directions, of those that keep taut cables' lengths, energy falls: 0 of a stable
  // pose, 1 of a pass between two.
  int negative = 0;
};

// Of a structure whose cables do not stretch beyond their rest_length, by Newton's method, at most
// `reach` away: turn of edges in radians, or motion over the length of the longest rod. forces:
// about those there, as stretching does not tell them of stiff rods; tensions >= 0. Not set: there
// is none, or cables go slack and taut in turn.
std::optional<Stationary> stationary_near(const model::Structure& structure,
                                          const model::State& state, const InternalForces& forces,
                                          double reach);

}  // namespace tencer::equilibrium
