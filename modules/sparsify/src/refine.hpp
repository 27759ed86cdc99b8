// A network's cables improved by an outer optimizer, in rounds.
#pragma once

#include <string>
#include <tencer/optimize/backend.hpp>
#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/network.hpp>
#include <tencer/sparsify/outer.hpp>
#include <tencer/sparsify/rules.hpp>

#include "removal.hpp"

namespace tencer::sparsify {

struct RefineSetup {
  // T is measured in this many percent (of the target's diagonal), rms.
  double percent = 1.0;
  // Weights of sqrt(q / reference), q a cable's force density, summed over the cables to anchors
  // and over the others (eq. 8). Cables whose q vanishes are taken out.
  double external = 0.0;
  double internal = 0.0;
  double reference = 1.0;
  bool slide = false;             // attachments are variables too
  double least_eigenvalue = 0.0;  // states softer than this are not entered
  Rules rules{};
};

struct Refined {
  Network network{};
  sensitivity::Deviation deviation{};
  std::string note{};  // why it ended early; empty when it did not
};

// Requires an equilibrium in which every cable pulls, as the result is.
Refined refine(const Network& network, const sensitivity::Target& target, const RefineSetup& setup,
               const optimize::Backend& backend, const OuterOptions& outer, const Control& control,
               Effort& effort);

// T of a shape that is `percent` of the target's diagonal away, rms.
double distance_scale(const sensitivity::Target& target, double percent);

// OuterOptions::least_eigenvalue, or half of what the network has with rest lengths of 99 %.
double least_eigenvalue(const Network& network, const OuterOptions& outer);

// Tension per length of each cable.
Eigen::VectorXd force_densities(const Network& network);

}  // namespace tencer::sparsify
