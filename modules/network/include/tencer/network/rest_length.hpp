// Springs that pull the same with other rest lengths: the same equilibrium, more or less stiff
// (paper section 5.3, "Spring rest length").
#pragma once

#include <tencer/network/network.hpp>

namespace tencer::network {

// The ratio of rest length to length of cables that are as good as inextensible: they hold what
// Newton's method would otherwise chase, and their stiffness is still far from rounding.
inline constexpr double stiff_rest_ratio = 0.999;

// Every spring with rest length rest_ratio (in [0, 1)) times its present length, and the stiffness
// that keeps its tension. Throws std::invalid_argument unless every cable pulls.
Network rebased(Network network, double rest_ratio);

struct RestLengthOptions {
  // The eigenvalue asked for, as a fraction of that at the rest ratio 0.99. 0: stable is enough, as
  // in the paper. An optimizer that starts next to the loss of stability makes short steps only.
  double margin = 0.0;
  // The same as a value, in the units of equilibrium::Stability. No more than 90 % of the
  // eigenvalue at 0.99 is asked for.
  double min_eigenvalue = 0.0;

  // Throws std::invalid_argument, naming the field, unless margin is in [0, 1).
  void validate() const;
};

struct RestLength {
  double rest_ratio = 0.0;           // 0, 0.01, ..., 0.99; failing these 0.999 to 0.99999
  double smallest_eigenvalue = 0.0;  // there, in the units of equilibrium::Stability
  bool stable = false;               // false: not even the last is stable
};

// The smallest rest ratio for which the rebased network is stable with the margin asked for. The
// Hessian grows with it (by force density times r / (1 - r) along each spring), so bisection finds
// it.
[[nodiscard]] RestLength smallest_stable_rest_length(const Network& network,
                                                     const RestLengthOptions& options = {});

// The eigenvalue at the rest ratio 0.99, as good as inextensible, or at the first beyond that is
// stable; minus infinity when rods are free to move against each other.
[[nodiscard]] double stiffest_eigenvalue(const Network& network);

}  // namespace tencer::network
