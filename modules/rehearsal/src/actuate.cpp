#include <optional>
#include <tencer/rehearsal/actuate.hpp>
#include <utility>

#include "resting.hpp"

namespace tencer::rehearsal {
namespace {

certify::Closest unscaled(certify::Closest closest, double length) {
  const auto grow = [&](auto& pair) {
    if (pair) pair->distance *= length;
  };
  grow(closest.rods);
  grow(closest.cable_rod);
  grow(closest.cables);
  grow(closest.marks);
  if (closest.rods) {
    closest.rods->s_a *= length;
    closest.rods->s_b *= length;
  }
  if (closest.cable_rod) closest.cable_rod->s *= length;
  if (closest.marks) {
    closest.marks->s_a *= length;
    closest.marks->s_b *= length;
  }
  return closest;
}

ActuatedPose posed(const Resting& start, const motion::Frame& frame,
                   const std::vector<Eigen::Matrix3Xd>& before) {
  const core::Scale& scale = start.scaling.scale;
  Fitted fit = fitted(start, frame.state, before);
  ActuatedPose result{.step = frame.leg,
                      .part = frame.part,
                      .pose = std::move(fit.pose),
                      .pose_directors = std::move(fit.directors),
                      .energy = frame.energy * scale.energy,
                      .closest = unscaled(frame.closest, scale.length)};
  for (Eigen::Index c = 0; c < frame.lengths.size(); ++c)
    result.built.push_back(
        {.length = frame.lengths[c] * scale.length, .tension = frame.tensions[c] * scale.force()});
  return result;
}

}  // namespace

model::Design in_pose(const model::Design& design, const ActuatedPose& pose) {
  model::Design result = design;
  result.pose = pose.pose;
  result.pose_directors = pose.pose_directors;
  result.built = pose.built;
  result.strains.clear();
  result.error.reset();
  result.certificate.reset();
  result.check.reset();
  return result;
}

core::Expected<Actuated> actuate(const model::Design& design, const model::Schedule& schedule,
                                 const std::stop_token& stop) {
  std::optional<Resting> start = resting(design, stop);
  if (!start)
    return core::Error{design.name,
                       "the design does not rest in its pose, so nothing can be pulled from "
                       "there; tencer simulate -o gives one that does"};
  const core::Scale& scale = start->scaling.scale;
  std::vector<motion::Leg> legs;
  const auto lengths = model::lengths_of(schedule, design);
  for (std::size_t k = 0; k < lengths.size(); ++k)
    legs.push_back({lengths[k] / scale.length, schedule.steps[k].frames});
  motion::Actuation found =
      motion::actuate(start->structure, start->state, start->tensions, legs, stop);
  Actuated result{.jumps = std::move(found.jumps), .finished = found.finished};
  for (const motion::Frame& frame : found.frames)
    result.poses.push_back(
        posed(*start, frame, result.poses.empty() ? start->design.pose : result.poses.back().pose));
  for (motion::Jump& jump : result.jumps) {
    jump.released *= scale.energy;
    jump.moved *= scale.length;
  }
  result.design = std::move(start->design);
  return result;
}

}  // namespace tencer::rehearsal
