// Where a structure without inertia goes when it is let go, pose by pose: the steepest descent of
// its energy in the metric of the rods' mass; and where it is while a hand pushes it.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <tencer/equilibrium/system.hpp>
#include <tencer/linalg/symmetric_factor.hpp>
#include <vector>

namespace tencer::equilibrium {

struct FlowPose {
  model::State state{};
  InternalForces forces{};
  double energy = 0.0;  // of rods and loads
  // How fast it goes on, in lengths of the longest rod; a unit of time takes a mode of eigenvalue 1
  // (see Stability) from 1 to 1 / e. 0 where it starts.
  double speed = 0.0;
};

struct FlowOptions {
  // Largest step: turn of an edge in radians, or motion over the length of the longest rod.
  double max_step = 0.05;
  int max_steps = 1000;
  // Ends there: asked at every pose.
  std::function<bool(const FlowPose&)> arrived{};
  std::stop_token stop{};
};

struct [[nodiscard]] Descent {
  std::vector<FlowPose> poses{};  // the first is the start
  // It arrived, or no longer moves; false: it was stopped, or could not be followed further.
  bool rests = false;
};

// Cables of the structure do not stretch, or as little as rods do: exactly not at a pose at which
// they pull with `tensions`.
class Flow {
 public:
  // tensions: one >= 0 a cable. Throws std::invalid_argument otherwise, and for a cable without
  // length.
  Flow(const model::Structure& structure, const Eigen::VectorXd& tensions);

  const System& system() const { return system_; }

  FlowPose at(model::State state) const;

  // Steps of implicit Euler, each the least of energy and squared distance from the pose before.
  Descent descend(FlowPose from, const FlowOptions& options = {});

  // Drawn by springs to where it is `ahead`, all per free unknown. A spring is told by the
  // eigenvalue (see Stability) that it has with the mass it draws. Not set: that far it cannot be
  // followed, or the springs are too soft to hold it.
  std::optional<FlowPose> drawn(const FlowPose& from, const Eigen::VectorXd& ahead,
                                const Eigen::VectorXd& springs);

 private:
  struct Moved {
    FlowPose pose{};
    double moved = 0.0;  // in lengths of the longest rod
    double size = 0.0;   // as FlowOptions::max_step
  };
  std::optional<Moved> least_near(const FlowPose& from, const Eigen::VectorXd& ahead,
                                  const Eigen::VectorXd& holding, double reach);
  double size_of(const model::State& state, const Eigen::VectorXd& motion) const;

  System system_;
  System rods_;  // without cables
  Eigen::VectorXd mass_;
  double unit_ = 0.0;     // of rates: eigenvalue_unit
  double longest_ = 0.0;  // of the rods
  linalg::SymmetricFactor factor_{};
};

}  // namespace tencer::equilibrium
