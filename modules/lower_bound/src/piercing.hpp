// The fewest points that meet every one of some intervals, on a line or a circle.
#pragma once

#include <vector>

namespace tencer::lower_bound {

// The cells from `from` to `to - 1`.
struct Interval {
  int from = 0;
  int to = 0;
};

// How many cells it takes that every interval has one of them. On a line of cells from 0 up.
int fewest_on_line(std::vector<Interval> intervals);
// On a circle of `cells`, with from in [0, cells) and to <= from + cells.
int fewest_on_circle(const std::vector<Interval>& intervals, int cells);

}  // namespace tencer::lower_bound
