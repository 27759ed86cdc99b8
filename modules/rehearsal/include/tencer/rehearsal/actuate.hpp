// What a design does when its cables are pulled and let go.
#pragma once

#include <Eigen/Core>
#include <stop_token>
#include <tencer/certify/closest.hpp>
#include <tencer/core/error.hpp>
#include <tencer/model/design.hpp>
#include <tencer/model/schedule.hpp>
#include <tencer/motion/actuate.hpp>
#include <vector>

namespace tencer::rehearsal {

// A pose at rest, in the design's units.
struct ActuatedPose {
  int step = 0;       // of the schedule; the first pose, before all of them, is of step 0 too
  double part = 0.0;  // of the step
  std::vector<Eigen::Matrix3Xd> pose{};  // per rod, 3 x n
  std::vector<Eigen::Matrix3Xd> pose_directors{};
  std::vector<model::BuiltCable> built{};  // one a cable; slack ones pull with 0
  double energy = 0.0;                     // of rods and loads; force times length
  certify::Closest closest{};
};

struct [[nodiscard]] Actuated {
  model::Design design{};  // as it was given, at rest
  std::vector<ActuatedPose> poses{};
  std::vector<motion::Jump> jumps{};  // of poses, by index
  bool finished = false;
};

// The design at a pose of it, with what is no longer known of it left out: error, certificate,
// check, strains.
model::Design in_pose(const model::Design& design, const ActuatedPose& pose);

// See motion/actuate.hpp. A structure that nothing holds is moved to fit the pose before. Errors:
// the design does not rest in its pose.
core::Expected<Actuated> actuate(const model::Design& design, const model::Schedule& schedule,
                                 const std::stop_token& stop = {});

}  // namespace tencer::rehearsal
