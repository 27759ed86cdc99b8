// Units of length as people write them in files.
#pragma once

#include <optional>
#include <string_view>

namespace tencer::io {

// The one of curve_units() that a word means, such as "mm" or "Inches"; not set: none.
std::optional<std::string_view> unit_meant(std::string_view word);

// The unit that a line of a header or a comment names: "x (mm)", "x_mm", "unit: mm".
std::optional<std::string_view> unit_in(std::string_view line);

}  // namespace tencer::io
