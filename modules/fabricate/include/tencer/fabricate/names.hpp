// How the bench writes lengths and the ends of cables.
#pragma once

#include <string>
#include <tencer/springs/cable.hpp>

namespace tencer::fabricate {

// "A 103.4" for arc length 103.4 (in whatever unit it is) on the first rod, or the anchor's name.
std::string end_name(const springs::End& end);

// With one decimal: a tenth of a millimetre is all that anyone cuts.
std::string tenths(double mm);

}  // namespace tencer::fabricate
