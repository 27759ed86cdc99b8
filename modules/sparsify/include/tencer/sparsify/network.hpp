// What every stage of the route takes and gives: a structure with its cables, in equilibrium, and
// what the stage did.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <tencer/equilibrium/solve.hpp>
#include <vector>

namespace tencer::sparsify {

struct Network {
  equilibrium::Structure structure{};
  equilibrium::State
      state{};  // an equilibrium of `structure`, unless a stage's note says otherwise
};

// One line of the record of error against run time.
struct StageRow {
  std::string stage{};
  double seconds = 0.0;
  int cables = 0;
  double max_percent = 0.0;  // distance to the target, in % of its bounding-box diagonal
  double rms_percent = 0.0;
  int solves = 0;      // of equilibria
  int iterations = 0;  // of Newton's method in all of them
  std::string note{};  // what is out of the ordinary, in words; empty when nothing is
};

struct StageResult {
  Network network{};
  std::vector<StageRow> trace{};
  bool interrupted = false;  // by Control::stop; `network` is the best so far
  // The network is in stable equilibrium and every cable pulls.
  bool sound = false;
};

struct Progress {
  std::string_view stage{};
  int cables = 0;
  double max_percent = 0.0;
  double seconds = 0.0;  // since the stage began
};

// How a stage is watched and stopped, and how accurately equilibria are solved.
struct Control {
  std::stop_token stop{};
  std::function<void(const Progress&)> progress{};  // may be empty
  equilibrium::SolveOptions solve{};
};

// |d| of every cable at a state, and the tension k (|d| - l).
Eigen::VectorXd cable_lengths(const Network& network);
Eigen::VectorXd cable_tensions(const Network& network);

// The cables that do not pull: tension at most 1e-9 of the largest.
std::vector<int> idle_cables(const Network& network);

}  // namespace tencer::sparsify
