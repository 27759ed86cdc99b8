// How few cables could do: proven, not found.
#pragma once

#include <string>
#include <tencer/model/rules.hpp>
#include <vector>

namespace tencer::model {

// Every equilibrium within the error has so many cables that pull.
struct AtLeast {
  int cables = 0;
  int ends = 0;                // of cables, on rods
  double error_percent = 0.0;  // of the target's size
  // Between the two ends of each is an end of a cable: lengths are the target's. An arc of a closed
  // rod may go past its end.
  std::vector<Arc> stretches{};
};

// In a sentence without its end; empty when no cable is known to be needed.
std::string in_words(const AtLeast& at_least);

}  // namespace tencer::model
