// OBJ polylines.
#pragma once

#include <string>
#include <string_view>
#include <tencer/geometry/polyline.hpp>
#include <vector>

namespace tencer::io {

// Throws BadInput; `file` is the name for its places.
std::vector<geometry::Polyline> parse_obj(std::string_view text, const std::string& file);

}  // namespace tencer::io
