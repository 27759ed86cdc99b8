// The data of an SVG path, and lists of numbers as SVG writes them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "curves/drawing.hpp"

namespace tencer::io {

// Numbers between blanks and commas, or with nothing between where a sign or point begins the next.
// Throws BadInput.
std::vector<double> svg_numbers(std::string_view text, const std::string& where);

// The strokes of a path's `d`: M L H V C S Q T A Z and their relative forms. A stroke that Z closes
// is closed. Points that are drawn to no other are left out. Throws BadInput.
std::vector<Stroke> svg_strokes(std::string_view data, const std::string& where);

}  // namespace tencer::io
