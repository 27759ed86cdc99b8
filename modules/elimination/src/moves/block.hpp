// Some rods of a network with the cables among them, while the other rods are held where they are:
// what can be searched by itself when a network has many rods (block coordinate descent).
#pragma once

#include <tencer/model/rules.hpp>
#include <tencer/model/target.hpp>
#include <tencer/network/network.hpp>
#include <vector>

namespace tencer::elimination {

struct Block {
  std::vector<int> rods{};     // numbers in the whole
  network::Network network{};  // cables to the rods that are held come first, to anchors
  int fixed_cables = 0;        // so many
  model::Target target{};      // where the whole's is, once aligned
  model::Rules rules{};        // those of the whole, but for which rods cables may join
};

// soft_rest_ratio: rest length relative to length of cables to rods that are held.
Block block_of(const network::Network& whole, const model::Target& target,
               const model::Rules& rules, std::vector<int> rods, double soft_rest_ratio);

// The whole with the cables of `changed`, the block's network without some cables, in place of the
// block's own, and the block's rods where they are in it.
network::Network with_block(network::Network whole, const Block& block,
                            const network::Network& changed);

// The pairs of rods that cables join, and the rods that cables join to no other, each by itself.
std::vector<std::vector<int>> joined_rods(const model::Structure& structure);

}  // namespace tencer::elimination
