// Which pieces are cut from which bar or coil.
#pragma once

#include <span>
#include <vector>

namespace tencer::fabricate {

struct Packing {
  std::vector<std::vector<int>> bars{};  // the pieces of each, by index, the longest first
  int lower_bound = 0;                   // no way of cutting needs fewer bars
};

// First fit decreasing: each piece, the longest first, into the first bar that it fits. What a saw
// takes is not counted. Throws std::invalid_argument unless stock and pieces are positive and
// finite, and no piece is longer than the stock.
Packing pack(std::span<const double> pieces, double stock);

// The pieces of a rod of this length where it is longer than the stock: whole bars, and the rest,
// each overlapping the one before. Throws std::invalid_argument unless length and stock are
// positive and finite and 0 <= overlap < stock.
std::vector<double> spliced(double length, double stock, double overlap);

}  // namespace tencer::fabricate
