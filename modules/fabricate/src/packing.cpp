#include <algorithm>
#include <cmath>
#include <numeric>
#include <tencer/core/error.hpp>
#include <tencer/fabricate/packing.hpp>

namespace tencer::fabricate {
namespace {

// Rounding must not ask for another bar.
constexpr double slack = 1e-9;

bool usable(double length) { return std::isfinite(length) && length > 0; }

}  // namespace

Packing pack(std::span<const double> pieces, double stock) {
  core::require(usable(stock), "pack: the stock must be positive and finite");
  for (const double piece : pieces)
    core::require(usable(piece) && piece <= stock * (1 + slack),
                  "pack: pieces must be positive and no longer than the stock");
  std::vector<int> order(pieces.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](int a, int b) { return pieces[a] > pieces[b]; });
  Packing packing;
  std::vector<double> left;
  double sum = 0;
  int longer_than_half = 0;
  for (const int piece : order) {
    const double length = pieces[piece];
    sum += length;
    if (length > stock / 2 * (1 + slack)) ++longer_than_half;  // no two of them share a bar
    auto bar =
        std::ranges::find_if(left, [&](double rest) { return length <= rest + slack * stock; });
    if (bar == left.end()) {
      packing.bars.emplace_back();
      bar = left.insert(left.end(), stock);
    }
    *bar -= length;
    packing.bars[bar - left.begin()].push_back(piece);
  }
  packing.lower_bound =
      std::max(static_cast<int>(std::ceil(sum / stock * (1 - slack))), longer_than_half);
  return packing;
}

std::vector<double> spliced(double length, double stock, double overlap) {
  core::require(usable(length) && usable(stock), "spliced: lengths must be positive and finite");
  core::require(overlap >= 0 && overlap < stock, "spliced: bars must be longer than the overlap");
  std::vector<double> pieces;
  double rest = length;
  while (rest > stock * (1 + slack)) {
    pieces.push_back(stock);
    rest -= stock - overlap;
  }
  pieces.push_back(rest);
  return pieces;
}

}  // namespace tencer::fabricate
