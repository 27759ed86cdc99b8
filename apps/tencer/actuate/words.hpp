// What a design does when it is actuated, in words and as a table.
#pragma once

#include <string>
#include <tencer/rehearsal/actuate.hpp>

namespace tencer::app {

// A line for each step, and below it one for each jump. The design's units are known.
std::string in_words(const rehearsal::Actuated& actuated);

// "step 2, 40 %", of a pose.
std::string label_of(const rehearsal::ActuatedPose& pose);

// CSV, a line a pose: where in the schedule it is, what happens next, energy, least distance of
// strands, length and tension of every cable, in the design's units.
std::string poses_csv(const rehearsal::Actuated& actuated);

}  // namespace tencer::app
