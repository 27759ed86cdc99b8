// One line of the record of error against run time.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace tencer::model {

// A network that the search went through, as it stood, to be looked at: nothing in it has a number,
// so that it is the same whichever rods it was found on.
struct Snapshot {
  double max_percent = 0.0;              // as StageRow has it
  std::vector<Eigen::Matrix3Xd> rods{};  // 3 x n each; a closed one ends where it starts
  Eigen::Matrix3Xd cable_ends{};         // 3 x 2 c: the ends of a cable beside each other
  Eigen::VectorXd tensions{};            // one a cable; below zero where it pushes

  int cables() const { return static_cast<int>(tensions.size()); }
};

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
  std::vector<Snapshot> snapshots{};  // what it went through, the last at its end; or none
};

}  // namespace tencer::model
