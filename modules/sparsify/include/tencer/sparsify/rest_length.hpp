// Springs that pull the same with other rest lengths: the same equilibrium, more or less stiff
// (paper section 5.3, "Spring rest length").
#pragma once

#include <tencer/sparsify/network.hpp>

namespace tencer::sparsify {

// Every spring with rest length rho times its present length, rho in [0, 1), and the stiffness that
// keeps its tension. Requires that every cable pulls.
Network rebased(Network network, double rho);

struct RestLengthOptions {
  // The eigenvalue asked for, as a fraction of that at rest lengths of 99 %. 0: stable is enough,
  // as in the paper. An optimizer that starts next to the loss of stability makes short steps only.
  double margin = 0.0;
  double least = 0.0;  // the same as a value; more than 90 % of that at 99 % is not asked for
};

struct RestLength {
  double rho = 0.0;                  // 0, 0.01, ..., 0.99; failing these 0.999 to 0.99999
  double smallest_eigenvalue = 0.0;  // there, in the units of equilibrium::Stability
  bool stable = false;               // false: not even the last is stable
};

// The smallest rho for which rebased(network, rho) is stable with the margin asked for. The Hessian
// grows with rho (by force density times rho / (1 - rho) along each spring), so bisection finds it.
RestLength smallest_stable_rest_length(const Network& network,
                                       const RestLengthOptions& options = {});

// The eigenvalue at rest lengths of 99 %, as good as inextensible, or at the first beyond that is
// stable; minus infinity when rods are free to move against each other.
double stiffest_eigenvalue(const Network& network);

}  // namespace tencer::sparsify
