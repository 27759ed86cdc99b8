// Networks of few candidates that nearly balance the forces at the target: where a convex problem
// spreads the forces over many cables, a few of them, chosen together, may do almost as well.
#pragma once

#include <span>
#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/network.hpp>
#include <tencer/symmetry/group.hpp>
#include <vector>

#include "removal.hpp"

namespace tencer::sparsify {

// A beam search over sets of candidates, orbit by orbit of the group: in each round every set of
// the beam takes in the orbit with which least is left over of the forces, measured by the
// displacements they cause (as in balance_forces), all tensions positive. The best sets of each
// round are solved for, from the target; what is not stable there, has idle cables or ends far from
// the target is dropped. Of each number of cables, at most `most`, the one that ends closest; the
// fewest cables first.
std::vector<Network> select_few(const Network& bare, const sensitivity::Target& target,
                                std::span<const springs::Cable> candidates,
                                const symmetry::Group& symmetry, int most, const Control& control,
                                Effort& effort);

}  // namespace tencer::sparsify
