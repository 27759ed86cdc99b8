// From the dense network to one that only pulls, and from that to fewer springs (paper section
// 5.2).
#pragma once

#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/network.hpp>

namespace tencer::sparsify {

// Takes out all springs in compression and solves again, until none is left. network.state is where
// the first solve starts.
StageResult prune(const Network& network, const sensitivity::Target& target,
                  const Control& control = {});

struct DecimateOptions {
  // Ends when |x - target| (all coordinates of all n vertices) exceeds threshold * n * L, L the
  // rods' total length; the paper's 5e-6 L n. That is an rms distance of threshold * sqrt(n) * L.
  double threshold = 5e-6;
};

// Takes out the spring with the smallest tension, then those that came into compression, again and
// again. The result is the last network within the threshold, or the given one when that exceeds
// it.
StageResult decimate(const Network& network, const sensitivity::Target& target,
                     const DecimateOptions& options = {}, const Control& control = {});

}  // namespace tencer::sparsify
