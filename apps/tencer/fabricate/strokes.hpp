// Lines with gaps, where others pass over them.
#pragma once

#include <vector>

#include "fabricate/canvas.hpp"

namespace tencer::app {

// Along a line on paper, mm from its start; on a closed one it may reach across the seam.
struct Gap {
  double from = 0.0;
  double to = 0.0;
};

// The lengths along a line from its first point to each (n), and on a closed one back to it (n +
// 1).
Eigen::VectorXd lengths_along(const Path& line, bool closed);

// What is left of a line between gaps, without points nearer to each other than anyone sees.
std::vector<Path> strokes(const Path& line, bool closed, std::vector<Gap> gaps);

}  // namespace tencer::app
