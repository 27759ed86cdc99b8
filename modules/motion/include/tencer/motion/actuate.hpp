// What a structure does while its cables, which do not stretch, change length slowly: the poses
// that it goes through, and where it jumps from one to another.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <stop_token>
#include <tencer/certify/closest.hpp>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::motion {

// The cables go to these lengths (> 0, one a cable), all in proportion.
struct Leg {
  Eigen::VectorXd lengths{};
  int frames = 10;  // poses told on the way, at equal parts of it
};

// A pose at rest.
struct Frame {
  int leg = 0;
  double part = 0.0;  // of the leg
  model::State state{};
  Eigen::VectorXd lengths{};   // of the cables; slack ones are as long as they may be
  Eigen::VectorXd tensions{};  // 0 of slack cables
  double energy = 0.0;         // of rods and loads
  certify::Closest closest{};
};

enum class Cause {
  turning,    // beyond these lengths there is no pose next to those before
  branching,  // there is, and it is unstable
  lost        // it could not be told: the poses could not be followed further
};

// Where the structure leaves the poses that it goes through.
struct Jump {
  int before = 0;  // the frame it leaves
  int after = 0;   // the frame where it comes to rest: the next, with the same lengths, about
  Cause cause = Cause::turning;
  // It bends over into other poses that begin here, with no jump: it buckles.
  bool smooth = false;
  double released = 0.0;  // energy, from before to after
  double moved = 0.0;     // largest distance of a vertex, the structure moved to fit unless held
  // Two strands may have passed through each other on the straight way there.
  bool strands_met = false;
};

struct [[nodiscard]] Actuation {
  std::vector<Frame> frames{};  // the first is the start
  std::vector<Jump> jumps{};
  // False: it was stopped, or after the last frame no rest was found.
  bool finished = false;
};

// From `state`, a stable pose that `tensions` (one a cable) balance, in which cables are as long as
// there, slack ones as their rest_length, along each leg in turn (equilibrium/branch.hpp). Where
// the stable poses end it is relaxed with lengths a little further on, energy never growing, twice:
// it jumps where it comes as far however little that is. Throws std::invalid_argument when sizes do
// not fit.
Actuation actuate(const model::Structure& structure, const model::State& state,
                  const Eigen::VectorXd& tensions, const std::vector<Leg>& legs,
                  const std::stop_token& stop = {});

}  // namespace tencer::motion
