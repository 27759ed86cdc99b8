// In which order cables can be tied so that the structure stands by itself as early as it can,
// found by taking the finished one apart, a cable at a time.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <stop_token>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::motion {

// A cable tied to a structure that stands by itself.
struct Tied {
  int cable = 0;
  double moved = 0.0;     // largest distance of a vertex by tying it, fitted unless it is held
  double tension = 0.0;   // of the cable, once it is tied
  int parts = 1;          // groups of rods that nothing ties together before it is tied
  model::State before{};  // the pose before
};

// Why a cable cannot be let go slowly with the others as they are.
enum class Obstacle {
  falls,   // the structure jumps on the way, by more than 1 % of the rods' length
  touches  // two strands overlap or may pass through each other
};

struct Held {
  int cable = 0;
  Obstacle obstacle = Obstacle::falls;
};

// First `held`, while the rods are held in shape; then `steps` in turn, of which each is a way of
// stable poses in which no strands meet.
struct [[nodiscard]] TyingPlan {
  std::vector<Held> held{};
  std::vector<Tied> steps{};
  bool finished = false;  // false: stopped; `held` are those that were not looked at
};

// Of a stable pose that tensions (one a cable) balance. Of the cables that can be let go, always
// the one whose release moves the structure least, to first order. There may be an order with fewer
// `held`; none is looked for beyond this. Throws std::invalid_argument when sizes do not fit.
TyingPlan tying_plan(const model::Structure& structure, const model::State& state,
                     const Eigen::VectorXd& tensions, const std::stop_token& stop = {});

}  // namespace tencer::motion
