#include <sstream>
#include <tencer/certify/closest.hpp>

#include "check/pose.hpp"

namespace tencer::pipeline {
namespace {

// "rod 0 at 12.5", in the design's unit.
std::string place(const RestPose& pose, int rod, double s) {
  std::ostringstream text;
  text.precision(4);
  text << "rod " << rod << " at " << s * pose.scaling.scale.length << ' '
       << pose.design.length_unit;
  return text.str();
}

std::string cable(int c) { return "cable " + std::to_string(c); }

}  // namespace

model::Clear clear(const RestPose& pose) {
  const double unit = pose.scaling.scale.length;
  const certify::Closest found = certify::closest(pose.structure, pose.state);
  model::Clear result;
  if (const auto& rods = found.rods)
    result.rods = {.distance = rods->distance * unit,
                   .where = place(pose, rods->rod_a, rods->s_a) + " and " +
                            place(pose, rods->rod_b, rods->s_b)};
  if (const auto& pass = found.cable_rod)
    result.cable_rod = {.distance = pass->distance * unit,
                        .where = cable(pass->cable) + " and " + place(pose, pass->rod, pass->s)};
  if (const auto& cables = found.cables)
    result.cables = {.distance = cables->distance * unit,
                     .where = cable(cables->cable_a) + " and " + cable(cables->cable_b)};
  if (const auto& marks = found.marks)
    result.marks = {.distance = marks->distance * unit,
                    .where = place(pose, marks->rod, marks->s_a) + " and " +
                             place(pose, marks->rod, marks->s_b)};
  return result;
}

}  // namespace tencer::pipeline
