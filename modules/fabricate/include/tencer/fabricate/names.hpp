// What rods, cables and anchors are called at the bench, as in view.html: rods by letters, so that
// they are not taken for the cables' numbers, which count from 1.
#pragma once

#include <string>
#include <tencer/springs/cable.hpp>

namespace tencer::fabricate {

// "A" to "Z", "AA", "AB", ...
std::string rod_name(int rod);

std::string cable_name(int cable);    // "1"
std::string anchor_name(int anchor);  // "anchor 1"

// "A 103.4" for arc length 103.4 (in whatever unit it is) on rod 0, or the anchor's name.
std::string end_name(const springs::End& end);

// With one decimal: a tenth of a millimetre is all that anyone cuts.
std::string tenths(double mm);

}  // namespace tencer::fabricate
