// Networks that an elimination found.
#pragma once

#include <tencer/model/goal.hpp>
#include <tencer/network/stage.hpp>
#include <vector>

namespace tencer::elimination {

// Whether a network stands once it is built.
struct Standing {
  bool settles = false;    // let go at the target it comes to rest in its pose
  bool clear = false;      // gaps and tensions are as the rules and the workmanship ask
  double deviation = 0.0;  // by errors within the workmanship (95 %), to first order; a length
  // These errors keep it near its pose; looked at only when it settles and is clear.
  bool forgives = false;

  bool holds() const { return settles && clear && forgives; }
};

// A network that was fitted and is in stable equilibrium with every cable pulling, its cables as
// good as inextensible.
struct Solution {
  network::Network network{};
  double max_percent = 0.0;  // distance from the target, in % of its diagonal
  double rms_percent = 0.0;
  // In the units of equilibrium::Stability: an upper bound, from three approximate modes.
  double smallest_eigenvalue = 0.0;
  Standing standing{};

  int cables() const { return cable_count(network); }
  model::Score score() const { return {cables(), max_percent, standing.holds()}; }
};

struct [[nodiscard]] EliminationResult {
  // Its network is what the goal asks for, or what came nearest to it.
  network::StageResult stage{};
  // The fewest cables first, each closer to the target than all with fewer cables, or the first
  // that stands.
  std::vector<Solution> solutions{};
};

}  // namespace tencer::elimination
