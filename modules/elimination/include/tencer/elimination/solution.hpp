// Networks that an elimination found.
#pragma once

#include <tencer/model/goal.hpp>
#include <tencer/network/stage.hpp>
#include <vector>

namespace tencer::elimination {

// How a network stands once it is built.
struct Standing {
  model::Footing footing = model::Footing::none;
  double deviation = 0.0;  // by errors within the workmanship (95 %), to first order; a length

  bool stands() const { return footing == model::Footing::stands; }
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
  model::Score score() const { return {cables(), max_percent, standing.footing}; }
};

struct [[nodiscard]] EliminationResult {
  // Its network is what the goal asks for, or what came nearest to it.
  network::StageResult stage{};
  // The fewest cables first, each closer to the target than all with fewer cables, or the first of
  // its footing.
  std::vector<Solution> solutions{};
};

}  // namespace tencer::elimination
