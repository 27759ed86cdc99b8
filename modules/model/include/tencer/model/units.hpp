// The units that scenes may be in.
#pragma once

#include <span>
#include <string_view>

namespace tencer::model {

std::span<const std::string_view> length_units();  // mm, cm, m
std::span<const std::string_view> force_units();   // mN, N, kN

// The size of a unit in metres or newtons. Throws std::invalid_argument, naming those that there
// are, for another one.
double metres(std::string_view length_unit);
double newtons(std::string_view force_unit);

}  // namespace tencer::model
