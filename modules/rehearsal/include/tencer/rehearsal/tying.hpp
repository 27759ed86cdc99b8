// In which order the cables of a design can be tied.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <stop_token>
#include <tencer/model/design.hpp>
#include <tencer/motion/tying.hpp>
#include <vector>

namespace tencer::rehearsal {

// As motion::Tied, in the design's units.
struct TyingStep {
  int cable = 0;
  double moved = 0.0;
  double tension = 0.0;
  int parts = 1;
  std::vector<Eigen::Matrix3Xd>
      before{};  // per rod, 3 x n: the pose before, fitted to the design's
};

struct Tying {
  std::vector<motion::Held> held{};
  std::vector<TyingStep> steps{};
  bool finished = false;
};

// See motion/tying.hpp. Not set: the design does not rest in its pose.
std::optional<Tying> tying(const model::Design& design, const std::stop_token& stop = {});

}  // namespace tencer::rehearsal
