#include "piercing.hpp"

#include <algorithm>
#include <limits>

namespace tencer::lower_bound {

int fewest_on_line(std::vector<Interval> intervals) {
  std::ranges::sort(intervals, {}, &Interval::to);
  int count = 0;
  int last = std::numeric_limits<int>::min();  // the cell that was taken last
  for (const Interval& interval : intervals) {
    if (last >= interval.from) continue;
    last = interval.to - 1;
    ++count;
  }
  return count;
}

int fewest_on_circle(const std::vector<Interval>& intervals, int cells) {
  if (intervals.empty()) return 0;
  const Interval shortest =
      std::ranges::min(intervals, {}, [](const Interval& i) { return i.to - i.from; });
  int best = std::numeric_limits<int>::max();
  // One of the shortest interval's cells is taken: with each of them the rest is a line.
  for (int cell = shortest.from; cell < shortest.to; ++cell) {
    std::vector<Interval> others;
    for (const Interval& interval : intervals) {
      // Counted from the cell, in [0, cells): it has the cell when it begins there or goes past it.
      const int from = ((interval.from - cell) % cells + cells) % cells;
      const int to = from + interval.to - interval.from;
      if (from > 0 && to <= cells) others.push_back({from, to});
    }
    best = std::min(best, 1 + fewest_on_line(std::move(others)));
  }
  return best;
}

}  // namespace tencer::lower_bound
