// Which further cable would bring a network closest to its target.
#pragma once

#include <optional>
#include <span>

#include "walker.hpp"

namespace tencer::sparsify {

struct Offer {
  springs::Cable cable{};
  double tension = 0.0;  // with which the objective is predicted to be least
};

// The best of the candidates; none when no cable that pulls would help. candidates: as in
// rules.hpp.
std::optional<Offer> best_offer(const Walker& walker, const sensitivity::Target& target,
                                const Rules& rules, std::span<const springs::Cable> candidates);

// `network` with the cable in it, pulling with `tension` at the network's state.
Network with_cable(Network network, springs::Cable cable, double tension);

}  // namespace tencer::sparsify
