// The units a scene may be in, and their sizes in metres and newtons.
#pragma once

#include <array>
#include <string_view>

namespace tencer::io {

inline constexpr std::array<std::string_view, 3> length_units{"mm", "cm", "m"};
inline constexpr std::array<double, 3> metres{1e-3, 1e-2, 1.0};
inline constexpr std::array<std::string_view, 3> force_units{"mN", "N", "kN"};
inline constexpr std::array<double, 3> newtons{1e-3, 1.0, 1e3};

}  // namespace tencer::io
