// Curves of drawings in DXF: lines, arcs, circles, ellipses, polylines and splines.
#pragma once

#include <string>
#include <string_view>
#include <tencer/io/curve.hpp>

namespace tencer::io {

// Throws BadInput; `file` is the name for its places.
CurveFile parse_dxf(std::string_view text, const std::string& file);

}  // namespace tencer::io
