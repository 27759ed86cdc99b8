// The structure as it is built: cables that can neither stretch nor push (paper section 4,
// "Cables"), where it comes to rest, and what is certain of a state of it.
#pragma once

#include <Eigen/Core>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>
#include <tencer/model/certificate.hpp>
#include <vector>

namespace tencer::equilibrium {

struct [[nodiscard]] InextensibleEquilibrium {
  Equilibrium equilibrium{};   // its residual includes the tensions
  Eigen::VectorXd tensions{};  // per cable, >= 0
  // Largest excess of a cable over its length, relative to the length; of one that pulls, what it
  // lacks as well.
  double stretch = 0.0;
  int rounds = 0;  // updates of the tensions
};

// Where the structure comes to rest from `start` with every cable's length limited to its
// rest_length (stiffness and tension_only are ignored): method of multipliers on tension-only
// springs, from `tensions`, one >= 0 per cable, or balancing_tensions(). Usable when
// equilibrium.usable() holds; then stretch <= 1e-10 or as small as rounding allows. Throws
// std::invalid_argument for a cable without length.
InextensibleEquilibrium relax_inextensible(const model::Structure& structure, model::State start,
                                           const SolveOptions& options = {});
InextensibleEquilibrium relax_inextensible(const model::Structure& structure, model::State start,
                                           const Eigen::VectorXd& tensions,
                                           const SolveOptions& options = {});

// What is found out about a structure at a state with inextensible cables of the lengths they have
// there.
struct [[nodiscard]] Assessment {
  double residual = 0.0;       // force balance relative to the rods' internal force
  double unexplained = 0.0;    // what rounding of coordinates does not explain of the residual
  double turn = 0.0;           // of an edge, radians, by the Newton step to full balance
  Eigen::VectorXd tensions{};  // per cable; those of slack cables are 0
  std::vector<int> slack{};    // cables that would have to push, or do nothing
  Stability stability{};

  // Forces balance to 1e-6, or, in a rod so slender that its own axial force is not known better,
  // to 1e-2 when rounding explains what is left of that; no cable is slack, and the state is
  // stable.
  bool certified() const {
    const bool rounded = turn <= 1e-8 && unexplained <= 1e-6 && residual <= 1e-2;
    return (residual <= 1e-6 || rounded) && slack.empty() && stability.stable();
  }
  model::Certificate certificate() const;
};

// `tensions`: as the equilibrium has them, one per cable; a cable pulling with less than 1e-9 of
// the largest tension is slack. Throws std::invalid_argument unless there is one per cable.
Assessment assess(const model::Structure& structure, const model::State& state,
                  const Eigen::VectorXd& tensions);

}  // namespace tencer::equilibrium
