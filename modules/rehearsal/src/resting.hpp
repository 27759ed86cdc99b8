// A design at rest in its pose, as what follows it from there starts.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <stop_token>
#include <tencer/model/design.hpp>
#include <tencer/model/scaling.hpp>
#include <tencer/model/state.hpp>

namespace tencer::rehearsal {

struct Resting {
  model::Design design{};  // with the pose and tensions found
  model::Scaling scaling{};
  model::Structure structure{};  // scaled, cables as long as they are built
  model::State state{};
  Eigen::VectorXd tensions{};  // scaled
};

// Not set: it does not stay in its pose, or a cable's ends meet there.
std::optional<Resting> resting(const model::Design& design, const std::stop_token& stop);

// Where the vertices are, in the design's units, moved rigidly to fit `onto` (in these units too)
// unless the structure is held; directors, where there are any, likewise.
struct Fitted {
  std::vector<Eigen::Matrix3Xd> pose{};
  std::vector<Eigen::Matrix3Xd> directors{};
};
Fitted fitted(const Resting& resting, const model::State& state,
              const std::vector<Eigen::Matrix3Xd>& onto);

}  // namespace tencer::rehearsal
