// Some rods of a network with the cables among them, while the other rods are held where they are:
// what can be searched by itself when a network has many rods.
#pragma once

#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/network.hpp>
#include <tencer/sparsify/rules.hpp>
#include <vector>

namespace tencer::sparsify {

struct Part {
  std::vector<int> rods{};       // of the whole
  Network network{};             // cables to the rods that are held come first, to anchors
  int kept = 0;                  // so many
  sensitivity::Target target{};  // where the whole's is, once aligned
  Rules rules{};                 // those of the whole, but for which rods cables may join
};

Part part_of(const Network& whole, const sensitivity::Target& target, const Rules& rules,
             std::vector<int> rods);

// The whole with the part's cables, but for the kept ones, and its rods as they are in `changed`.
Network with_part(Network whole, const Part& part, const Network& changed);

// Pairs of rods that cables join, and rods that cables join to no other.
std::vector<std::vector<int>> joined_rods(const equilibrium::Structure& structure);

}  // namespace tencer::sparsify
