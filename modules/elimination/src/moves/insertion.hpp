// Which further cables would bring a network closest to its target, or make it firmest.
#pragma once

#include <span>
#include <vector>

#include "state/fitted_network.hpp"

namespace tencer::elimination {

struct Insertion {
  std::vector<springs::Cable> cables{};  // one, or an orbit
  double tension = 0.0;  // of each, with which the objective is predicted to be least
};

// The best of the candidates, at most `max_count`, the best first, no two of them alike: some end
// of one is at least options.alike of its rod away from both ends of the other. All candidates are
// priced by the adjoint, the steepest of them in full, with the others refitted.
std::vector<Insertion> best_insertions(const FittedNetwork& fitted,
                                       std::span<const springs::Cable> candidates, int max_count,
                                       const LocalSearchOptions& options);

// Likewise the candidates that as cables which do not stretch leave errors the least to move, by
// the softest modes; without errors the least compliance. They pull weakly.
std::vector<Insertion> best_braces(const FittedNetwork& fitted,
                                   std::span<const springs::Cable> candidates, int max_count,
                                   const LocalSearchOptions& options);

// `network` with the cables in it, pulling with `part` of their tension at the network's state.
network::Network with_insertion(network::Network network, const Insertion& insertion, double part);

}  // namespace tencer::elimination
