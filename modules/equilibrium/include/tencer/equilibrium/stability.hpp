// Certificates of stability: the smallest eigenvalue of the Hessian apart from rigid motion.
#pragma once

#include <Eigen/Core>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/system.hpp>
#include <vector>

namespace tencer::equilibrium {

// H v = lambda M v with one unit of mass per unit of rod length, on all motions but rigid ones; in
// units of max EI / L^4, L the total rod length, so that it depends neither on units nor on
// resolution (like a squared frequency: a free straight rod has 500.56). Twist follows positions
// statically.
struct Stability {
  double smallest_eigenvalue = 0.0;
  double rounding = 0.0;        // what rounding of the Hessian may have done to it
  int negative = 0;             // how many eigenvalues are negative
  int floating_components = 0;  // groups of rods free to move against each other at no cost
  bool computed = false;        // false: the eigenvalue iteration failed; nothing is certified
  Eigen::VectorXd mode{};       // of the smallest eigenvalue, in free unknowns, largest entry 1

  bool stable() const {
    return computed && negative == 0 && floating_components == 0 && smallest_eigenvalue > rounding;
  }
};

// With the cables as the springs they are.
Stability stability(const System& system, const model::State& state);

// With every cable in `taut` (indices into the structure's cables) inextensible and pulling with
// `tensions` (one per cable of the structure, >= 0), the others slack: the Hessian of the
// Lagrangian on the motions that keep the taut lengths. The cables' own stiffness and rest length
// do not count.
Stability stability_inextensible(const model::Structure& structure, const model::State& state,
                                 const Eigen::VectorXd& tensions, const std::vector<int>& taut);

}  // namespace tencer::equilibrium
