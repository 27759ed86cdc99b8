// A network's cables improved by an outer optimizer, in rounds.
#pragma once

#include <string>
#include <tencer/model/rules.hpp>
#include <tencer/network/stage.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <tencer/optimize/backend.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <tencer/sparsify/outer.hpp>

namespace tencer::sparsify {

struct RoundsSetup {
  // T is measured in units of this rms distance, in % of the target's diagonal.
  double unit_percent = 1.0;
  // Weights of sqrt(q / reference), q a cable's force density, summed over the cables to anchors
  // and over the others (eq. 8). Cables whose q vanishes are taken out.
  double external = 0.0;
  double internal = 0.0;
  double reference = 1.0;
  bool slide = false;           // attachments are variables too
  double min_eigenvalue = 0.0;  // states softer than this are not entered
  model::Rules rules{};
};

// The sparsity weight of a cable.
double weight_of(const springs::Cable& cable, const RoundsSetup& setup);

struct Improved {
  network::Network network{};
  sensitivity::Deviation deviation{};
  std::string note{};  // why it ended early; empty when it did not
};

// Requires an equilibrium in which every cable pulls, as the result is.
Improved improve_in_rounds(const network::Network& network, const model::Target& target,
                           const RoundsSetup& setup, const optimize::Backend& backend,
                           const OuterOptions& outer, const network::Control& control,
                           network::SolveCounts& counts);

// OuterOptions::min_eigenvalue, or half of what the network has with cables as good as
// inextensible.
double min_eigenvalue(const network::Network& network, const OuterOptions& outer);

}  // namespace tencer::sparsify
