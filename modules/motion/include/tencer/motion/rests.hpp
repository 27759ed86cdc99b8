// The poses in which a structure rests beside the one it is in, and the passes between them: what
// has to be lifted at least to go from one to another, and whether strands are in the way.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <stop_token>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::motion {

struct RestsOptions {
  int directions = 16;  // that every rest is pushed in
  double reach = 0.8;   // of a finger, of the size (diagonal of the box around the pose)
  int most_rests = 12;  // to push on from
  std::uint64_t seed = 1;
  std::stop_token stop{};

  // Throws std::invalid_argument, naming the field, unless all are positive.
  void validate() const;
};

// A stable pose.
struct Rest {
  model::State state{};
  Eigen::VectorXd tensions{};  // per cable; 0 of slack ones
  double energy = 0.0;         // of rods and loads
  double softest = 0.0;        // its smallest eigenvalue, see equilibrium/stability.hpp
  double away = 0.0;           // largest distance of a vertex from the first, fitted
  int found = 0;               // so many pushes ended here
};

struct WayPose {
  model::State state{};
  Eigen::VectorXd tensions{};
  double energy = 0.0;
};

// A saddle of the energy with one way down on each side.
struct Pass {
  int from = 0;  // rests, by index
  int to = 0;
  double energy = 0.0;
  std::vector<WayPose> way{};  // steepest descent to either side, from rest to rest
  int top = 0;                 // of the way: the saddle
  int found = 1;
  // Along the way. Least distance of strands of rods, negative where they overlap; infinite of a
  // rod that does not come near itself.
  double strands_apart = std::numeric_limits<double>::infinity();
  bool strands_met = false;           // two strands may have passed through each other
  std::optional<int> cable_in_rod{};  // a cable that goes through a rod

  // Whether it can be gone with strands that do not pass through each other.
  bool free() const { return strands_apart >= 0 && !strands_met && !cable_in_rod; }
};

struct [[nodiscard]] Rests {
  std::vector<Rest> rests{};   // the first is the one it starts in; none: that is not stable
  std::vector<Pass> passes{};  // by energy
  int pushes = 0;
  int lost = 0;           // of them ended in no stable pose that could be told
  int passes_missed = 0;  // pushes that went to another rest over a pass that was not found
  bool finished = false;  // false: stopped
};

// From `state`, a stable pose that `tensions` (one a cable) balance, with cables that do not
// stretch. A finger somewhere pushes every rest slowly in some direction (two, in opposite
// directions, where nothing holds the structure) and lets go, half way and at the end; what has no
// inertia comes to rest at the end of the steepest descent. Between a push from which it comes back
// and one from which it does not it passes near a saddle, which Newton's method then finds. That
// counts when it is unstable in one direction, and joins the two rests in which steepest descent
// ends from there. There may be more rests, and lower passes. The same for the same seed. Throws
// std::invalid_argument when sizes do not fit.
Rests find_rests(const model::Structure& structure, const model::State& state,
                 const Eigen::VectorXd& tensions, const RestsOptions& options = {});

// The passes to go over from one rest to each other so that the highest is as low as can be, by
// index, in order; none to itself, and to those that no passes lead to.
std::vector<std::vector<int>> lowest_ways(const Rests& rests, int from);

}  // namespace tencer::motion
