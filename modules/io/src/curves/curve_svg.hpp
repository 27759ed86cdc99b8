// Curves of drawings in SVG: paths and shapes, in the plane z = 0, y up.
#pragma once

#include <string>
#include <string_view>
#include <tencer/io/curve.hpp>

namespace tencer::io {

// Throws BadInput; `file` is the name for its places.
CurveFile parse_svg(std::string_view text, const std::string& file);

}  // namespace tencer::io
