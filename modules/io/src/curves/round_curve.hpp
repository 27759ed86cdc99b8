// Curves rounded on request, and what is said of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tencer/geometry/polyline.hpp>
#include <vector>

namespace tencer::io {

// Bends sharper than this radius become bends of it (geometry/rounding.hpp), on as many vertices as
// are asked for, else on no fewer than the curve has and enough for the bends; with a note that
// says where. A curve without such bends stays as it is. Set: why it cannot be rounded, which
// leaves it as it was.
[[nodiscard]] std::optional<std::string> round_curve(double radius, std::optional<int> vertices,
                                                     std::string_view length_unit,
                                                     geometry::Polyline& curve,
                                                     std::vector<std::string>& notes);

}  // namespace tencer::io
