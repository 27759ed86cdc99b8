// From the dense network to one that only pulls, and from that to fewer springs (paper section
// 5.2).
#pragma once

#include <functional>
#include <tencer/model/target.hpp>
#include <tencer/network/stage.hpp>

namespace tencer::sparsify {

struct PruneOptions {
  // Springs that push by this part of the hardest push or more go at once. 0: all that push, in few
  // solves. With half, the rods stay several times as near to where they were, in many.
  double hardest_part = 0.0;

  // A request to stop leaves the network as it was given, not checked: it takes long until many
  // springs balance and pull.
  bool all_or_nothing = false;

  // Throws std::invalid_argument, naming the field, unless it is a part.
  void validate() const;
};

// Takes out springs in compression and solves again, until none is left. network.state is where the
// first solve starts.
network::StageResult prune(const network::Network& network, const model::Target& target,
                           const PruneOptions& options = {}, const network::Control& control = {});

struct GreedyOptions {
  // The removal ends when |x - target| (all coordinates of all n vertices) exceeds threshold * n *
  // L, L the rods' total length; the paper's 5e-6 L n. That is an rms distance of threshold *
  // sqrt(n) * L.
  double threshold = 5e-6;
  int min_springs = 1;  // the removal ends with at most so many

  // Throws std::invalid_argument, naming the field, unless both are positive.
  void validate() const;
};

// Takes out the spring with the smallest tension, then those that came into compression, again and
// again. The result is the last network within the threshold, or the given one when that exceeds
// it.
network::StageResult remove_greedily(const network::Network& network, const model::Target& target,
                                     const GreedyOptions& options = {},
                                     const network::Control& control = {});

}  // namespace tencer::sparsify
