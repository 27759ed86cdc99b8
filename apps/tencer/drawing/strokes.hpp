// Lines with gaps, where others pass over them.
#pragma once

#include <vector>

#include "drawing/canvas.hpp"

namespace tencer::app {

// Along a line on paper, mm from its start; on a closed one it may reach across the seam. Its ends
// may be slanted, as what passes over is: on the left of the line they are by half of this further
// along, on the right as much less.
struct Gap {
  double from = 0.0;
  double to = 0.0;
  double slant_from = 0.0;
  double slant_to = 0.0;
};

// What is left of a line between gaps, and its ends' slants.
struct Stroke {
  Path line;
  double from = 0.0;  // mm from the start of the line it is of
  double to = 0.0;
  double slant_from = 0.0;
  double slant_to = 0.0;
};

// The lengths along a line from its first point to each (n), and on a closed one back to it (n +
// 1).
Eigen::VectorXd lengths_along(const Path& line, bool closed);

// What is left of a line between gaps, without points nearer to each other than anyone sees, and
// without what is shorter than `least` between two gaps. A line without gaps is one stroke from its
// start to its end; else a stroke goes on over the seam of a closed line, its `to` beyond the end.
std::vector<Stroke> strokes(const Path& line, bool closed, std::vector<Gap> gaps,
                            double least = 0.0);

// The outline of a stroke of this width, for an area.
Path outline(const Stroke& stroke, double width);

// A line on paper and where something is on it, mm from its start.
struct Spotted {
  const Path& line;
  const Eigen::VectorXd& lengths;  // lengths_along
  double at = 0.0;
};

// Where the line under is as near to the one over as `clear` (from its middle) or nearer, on both
// sides of the place where they cross. under_width: for the slant of its ends.
Gap gap_under(const Spotted& over, const Spotted& under, double clear, double under_width);

}  // namespace tencer::app
