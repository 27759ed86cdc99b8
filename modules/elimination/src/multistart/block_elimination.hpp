// Fewer cables among many rods, one block of them after another: where eliminations of the whole
// take long and end early.
#pragma once

#include "multistart/multistart.hpp"

namespace tencer::elimination {

// The network with fewer cables: they are taken out of pairs of joined rods, one pair after the
// other, while the other rods are held. As it is when it is not in stable equilibrium. Only without
// symmetry.
network::Network eliminate_in_blocks(Multistart& multistart, const network::Network& start);

}  // namespace tencer::elimination
