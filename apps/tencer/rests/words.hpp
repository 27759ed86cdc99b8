// The poses that a design rests in, in words and for programs.
#pragma once

#include <string>
#include <tencer/rehearsal/rests.hpp>

namespace tencer::app {

// A line for each pose, and one for each pass between two. The design's units are known.
std::string in_words(const rehearsal::DesignRests& found);

// The same and the energies along the ways as JSON, in mJ and mm.
std::string rests_json(const rehearsal::DesignRests& found);

// "rest 1 to rest 2, 40 %", of a pose on the way over a pass.
std::string label_of(const rehearsal::DesignPass& pass, std::size_t pose);

}  // namespace tencer::app
