// The certificate's two questions answered with one factorisation: does the structure with
// inextensible cables stand, and how far is it from full balance?
#pragma once

#include <limits>
#include <tencer/equilibrium/stability.hpp>

namespace tencer::equilibrium {

struct BalancedStability {
  Stability stability{};
  // How far the Newton step that balances the gradient turns an edge, radians.
  double turn = std::numeric_limits<double>::infinity();  // of an unstable state
};

// See stability_inextensible. gradient: of the rods, loads and tensions together.
BalancedStability balanced_stability(const model::Structure& structure, const model::State& state,
                                     const Eigen::VectorXd& tensions, const std::vector<int>& taut,
                                     const Eigen::VectorXd& gradient);

}  // namespace tencer::equilibrium
