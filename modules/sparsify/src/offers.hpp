// Which further cables would bring a network closest to its target.
#pragma once

#include <span>
#include <vector>

#include "walker.hpp"

namespace tencer::sparsify {

struct Offer {
  std::vector<springs::Cable> cables{};  // one, or an orbit
  double tension = 0.0;  // of each, with which the objective is predicted to be least
};

// The best of the candidates, at most so many, the best first, no two of them alike: some end of
// one is at least a tenth of its rod away from both ends of the other. candidates: as in rules.hpp.
std::vector<Offer> best_offers(const Walker& walker, const Task& task,
                               std::span<const springs::Cable> candidates, int most);

// `network` with the cables in it, pulling with `part` of their tension at the network's state.
Network with_offer(Network network, const Offer& offer, double part);

}  // namespace tencer::sparsify
