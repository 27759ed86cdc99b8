#include "piercing.hpp"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <random>

using namespace tencer::lower_bound;

namespace {

// By trying all sets of cells.
int by_trial(const std::vector<Interval>& intervals, int cells) {
  int best = cells;
  for (unsigned set = 0; set < (1U << cells); ++set) {
    const bool all = std::ranges::all_of(intervals, [&](const Interval& interval) {
      for (int cell = interval.from; cell < interval.to; ++cell)
        if (set >> (cell % cells) & 1U) return true;
      return false;
    });
    if (all) best = std::min(best, std::popcount(set));
  }
  return best;
}

}  // namespace

TEST_CASE("the fewest cells are those that trying all sets finds", "[lower_bound]") {
  constexpr int cells = 10;
  std::mt19937 random(3);
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<Interval> line, circle;
    for (int k = 0; k < trial % 9; ++k) {
      const int from = static_cast<int>(random() % cells);
      const int length = 1 + static_cast<int>(random() % 5);
      circle.push_back({from, from + length});
      line.push_back({from, std::min(cells, from + length)});
    }
    CHECK(fewest_on_line(line) == by_trial(line, cells));
    CHECK(fewest_on_circle(circle, cells) == by_trial(circle, cells));
  }
  CHECK(fewest_on_circle({}, cells) == 0);
  CHECK(fewest_on_circle({{4, 14}}, cells) == 1);
}
