#include <tencer/certify/closest.hpp>
#include <tencer/core/names.hpp>

#include "check/pose.hpp"

namespace tencer::pipeline {
namespace {

// In mm, as all of a check's words.
std::string places(const RestPose& pose, std::vector<core::Place> places) {
  for (core::Place& place : places)
    place.s *= pose.scaling.scale.length / millimetre_of(pose.design);
  return core::places_in_words(places, pose.structure.rods.size(), "mm");
}

}  // namespace

model::Clear clear(const RestPose& pose) {
  const double unit = pose.scaling.scale.length;
  const certify::Closest found = certify::closest(pose.structure, pose.state);
  model::Clear result;
  if (const auto& rods = found.rods)
    result.rods = {.distance = rods->distance * unit,
                   .where = places(pose, {{rods->rod_a, rods->s_a}, {rods->rod_b, rods->s_b}})};
  if (const auto& pass = found.cable_rod)
    result.cable_rod = {.distance = pass->distance * unit,
                        .where = core::cable_in_words(pass->cable) + " and " +
                                 places(pose, {{pass->rod, pass->s}})};
  if (const auto& cables = found.cables)
    result.cables = {.distance = cables->distance * unit,
                     .where = core::cable_in_words(cables->cable_a) + " and " +
                              core::cable_in_words(cables->cable_b)};
  if (const auto& marks = found.marks)
    result.marks = {.distance = marks->distance * unit,
                    .where = places(pose, {{marks->rod, marks->s_a}, {marks->rod, marks->s_b}})};
  return result;
}

}  // namespace tencer::pipeline
