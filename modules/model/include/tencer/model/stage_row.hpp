// One line of the record of error against run time.
#pragma once

#include <string>

namespace tencer::model {

struct StageRow {
  std::string stage{};
  double seconds = 0.0;  // spent in this stage
  int cables = 0;        // at its end
  // Largest and root-mean-square distance of the vertices to the target, in percent of its
  // bounding-box diagonal. NaN where the stage has none.
  double max_percent = 0.0;
  double rms_percent = 0.0;
  int solves = 0;      // of equilibria
  int iterations = 0;  // of Newton's method in all of them
  std::string note{};  // what is out of the ordinary, in words; empty when nothing is
};

}  // namespace tencer::model
