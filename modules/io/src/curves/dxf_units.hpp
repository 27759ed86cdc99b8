// How DXF numbers units of length ($INSUNITS).
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace tencer::io {

inline constexpr std::array<std::pair<int, std::string_view>, 5> dxf_units{
    {{1, "in"}, {2, "ft"}, {4, "mm"}, {5, "cm"}, {6, "m"}}};

inline std::optional<std::string_view> dxf_unit(int number) {
  for (const auto& [known, name] : dxf_units)
    if (known == number) return name;
  return std::nullopt;
}

inline std::optional<int> dxf_number(std::string_view unit) {
  for (const auto& [known, name] : dxf_units)
    if (name == unit) return known;
  return std::nullopt;
}

}  // namespace tencer::io
