// Curves of Geomview VECT files, as KnotPlot and tables of knots have them.
#pragma once

#include <string>
#include <string_view>
#include <tencer/io/curve.hpp>

namespace tencer::io {

// Throws BadInput; `file` is the name for its places.
CurveFile parse_vect(std::string_view text, const std::string& file);

}  // namespace tencer::io
