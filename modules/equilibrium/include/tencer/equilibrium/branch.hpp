// The branch of equilibria that a structure with inextensible cables is on while the cables'
// lengths change in proportion: followed by its own length, stable or not, around the points where
// it turns back. (path.hpp has the stable part alone, in as few steps as it can.)
#pragma once

#include <Eigen/Core>
#include <stop_token>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::equilibrium {

struct BranchOptions {
  // Largest step: turn of an edge in radians, or motion over the length of the longest rod.
  double max_step = 0.05;
  double min_step = 1e-7;  // the branch is lost where it cannot be followed in steps so small
  int frames = 1;          // so many equal parts of the way end in points of their own
  // Ends where the stable part of the branch does.
  bool stable_only = false;
  int max_points = 2000;
  std::stop_token stop{};

  // Throws std::invalid_argument, naming the field, unless all are positive.
  void validate() const;
};

// What happens at a point of a branch.
enum class Passing {
  none,
  turning,    // the way goes back from here: lengths can go no further
  branching,  // the branch becomes unstable or stable and goes on, and others leave from it
  slack,      // a cable goes slack
  taut        // or taut
};

struct BranchPoint {
  double part = 0.0;  // of the way
  model::State state{};
  Eigen::VectorXd tensions{};  // per cable; 0 of slack ones
  double energy = 0.0;         // of rods and loads; cables that do not stretch have none
  int negative = 0;            // just after it: in so many directions energy falls; 0: it is stable
  bool forward = true;         // just after it the way goes on, not back
  Passing passing = Passing::none;
  bool frame = false;  // one of BranchOptions::frames, or the start
};

enum class BranchEnd {
  arrived,      // at the end of the way
  back,         // before its beginning
  unstable,     // where it is no longer stable, as asked for
  lost,         // it cannot be followed further
  many_points,  // BranchOptions::max_points
  stopped
};

struct [[nodiscard]] Branch {
  std::vector<BranchPoint> points{};  // none: the start is in no equilibrium
  BranchEnd end = BranchEnd::lost;
};

// How long the cables are at a pose that `tensions` balance, one a cable: as long as there, and
// those of tension 0, which are slack, as their rest_length, or longer.
Eigen::VectorXd lengths_at(const model::Structure& structure, const model::State& state,
                           const Eigen::VectorXd& tensions);

// From lengths_at `state`, which `tensions` (>= 0, one a cable) balance, to where the cables have
// these lengths (> 0, one a cable). Predictor and corrector steps of the
// structure with taut cables as constraints and the part of the way as one more unknown; where it
// turns, where stability changes, and where cables go slack and taut is found to 1e-6 of a step or
// better, and a point of its own.
// Throws std::invalid_argument when sizes do not fit.
Branch follow_branch(const model::Structure& structure, const model::State& state,
                     const Eigen::VectorXd& tensions, const Eigen::VectorXd& lengths,
                     const BranchOptions& options = {});

}  // namespace tencer::equilibrium
