#include "actuate/words.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <tencer/core/words.hpp>
#include <tencer/io/csv.hpp>
#include <tencer/model/units.hpp>
#include <vector>

namespace tencer::app {
namespace {

using rehearsal::Actuated;
using rehearsal::ActuatedPose;

std::string digits(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

std::string millimetres(const Actuated& actuated, double length) {
  return digits(1e3 * model::metres(actuated.design.length_unit) * length) + " mm";
}

std::string millijoules(const Actuated& actuated, double energy) {
  return digits(1e3 * model::metres(actuated.design.length_unit) *
                model::newtons(actuated.design.force_unit) * energy) +
         " mJ";
}

std::string percent(double part) { return digits(std::round(1000 * part) / 10) + " %"; }

std::string largest_tension(const Actuated& actuated, const std::vector<ActuatedPose>& poses) {
  double largest = 0;
  std::size_t cable = 0;
  for (const ActuatedPose& pose : poses)
    for (std::size_t c = 0; c < pose.built.size(); ++c)
      if (pose.built[c].tension > largest) {
        largest = pose.built[c].tension;
        cable = c;
      }
  if (!(largest > 0)) return "all cables slack";
  return "largest tension " + digits(model::newtons(actuated.design.force_unit) * largest) +
         " N (cable " + std::to_string(cable + 1) + ")";
}

double strands_apart(const ActuatedPose& pose) {
  return pose.closest.rods ? pose.closest.rods->distance : std::numeric_limits<double>::infinity();
}

// Where strands come nearest, or first overlap, and whether a cable goes through a rod.
std::string clearance(const Actuated& actuated, const std::vector<ActuatedPose>& poses) {
  const auto nearest = std::ranges::min_element(poses, {}, strands_apart);
  const auto first =
      std::ranges::find_if(poses, [](const ActuatedPose& pose) { return strands_apart(pose) < 0; });
  std::string text;
  if (first != poses.end())
    text = "; strands overlap, first at " + percent(first->part) + ", by " +
           millimetres(actuated, -strands_apart(*nearest)) + " at most";
  else if (nearest->closest.rods)
    text = "; strands " + millimetres(actuated, strands_apart(*nearest)) + " apart at least, at " +
           percent(nearest->part);
  for (const ActuatedPose& pose : poses)
    if (pose.closest.cable_rod && pose.closest.cable_rod->distance < 0) {
      text += "; cable " + std::to_string(pose.closest.cable_rod->cable + 1) +
              " goes through a rod, first at " + percent(pose.part);
      break;
    }
  return text;
}

std::string in_words(const Actuated& actuated, const motion::Jump& jump) {
  const ActuatedPose& before = actuated.poses[static_cast<std::size_t>(jump.before)];
  std::string text = "  at " + percent(before.part) + ": ";
  if (jump.smooth)
    return text + "buckles: other poses begin here, and it bends over into them with no jump\n";
  text += "snaps: moves by " + millimetres(actuated, jump.moved) + " and releases " +
          millijoules(actuated, jump.released);
  if (jump.cause == motion::Cause::branching) text += "; its pose is unstable from here";
  if (jump.cause == motion::Cause::lost) text += "; its poses could not be followed up to here";
  if (jump.strands_met) text += "; strands may pass through each other on the way";
  return text + '\n';
}

}  // namespace

std::string label_of(const ActuatedPose& pose) {
  return "step " + std::to_string(pose.step + 1) + ", " + percent(pose.part);
}

std::string in_words(const Actuated& actuated) {
  std::string text;
  const int steps = actuated.poses.back().step + 1;
  for (int step = 0; step < steps; ++step) {
    std::vector<ActuatedPose> poses;
    for (const ActuatedPose& pose : actuated.poses)
      if (pose.step == step) poses.push_back(pose);
    if (poses.empty()) continue;
    text += "step " + std::to_string(step + 1) + ": " +
            core::counted(static_cast<int>(poses.size()), "pose") + ", energy " +
            millijoules(actuated, poses.front().energy) + " to " +
            millijoules(actuated, poses.back().energy) + ", " + largest_tension(actuated, poses) +
            clearance(actuated, poses) + '\n';
    for (const motion::Jump& jump : actuated.jumps)
      if (actuated.poses[static_cast<std::size_t>(jump.before)].step == step)
        text += in_words(actuated, jump);
  }
  if (!actuated.finished)
    text += "stopped at " + label_of(actuated.poses.back()) + ": no rest was found beyond\n";
  return text;
}

std::string poses_csv(const Actuated& actuated) {
  std::vector<std::string> row{"step", "part", "next", "energy", "strands_apart"};
  for (std::size_t c = 1; c <= actuated.design.built.size(); ++c) {
    row.push_back("length_" + std::to_string(c));
    row.push_back("tension_" + std::to_string(c));
  }
  std::string text = io::csv_line(row);
  for (std::size_t k = 0; k < actuated.poses.size(); ++k) {
    const ActuatedPose& pose = actuated.poses[k];
    const auto jump = std::ranges::find(actuated.jumps, static_cast<int>(k), &motion::Jump::before);
    const bool jumps = jump != actuated.jumps.end();
    row = {std::to_string(pose.step + 1), io::to_text(pose.part),
           !jumps         ? ""
           : jump->smooth ? "buckles"
                          : "snaps",
           io::to_text(pose.energy),
           pose.closest.rods ? io::to_text(pose.closest.rods->distance) : ""};
    for (const model::BuiltCable& cable : pose.built) {
      row.push_back(io::to_text(cable.length));
      row.push_back(io::to_text(cable.tension));
    }
    text += io::csv_line(row);
  }
  return text;
}

}  // namespace tencer::app
