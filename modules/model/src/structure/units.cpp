#include <algorithm>
#include <array>
#include <tencer/core/error.hpp>
#include <tencer/model/units.hpp>

namespace tencer::model {
namespace {

constexpr std::array<std::string_view, 3> lengths{"mm", "cm", "m"};
constexpr std::array<double, 3> metres_each{1e-3, 1e-2, 1.0};
constexpr std::array<std::string_view, 3> forces{"mN", "N", "kN"};
constexpr std::array<double, 3> newtons_each{1e-3, 1.0, 1e3};

}  // namespace

std::span<const std::string_view> length_units() { return lengths; }
std::span<const std::string_view> force_units() { return forces; }

double metres(std::string_view length_unit) {
  const auto* found = std::ranges::find(lengths, length_unit);
  core::require(found != lengths.end(), "length_unit: expected mm, cm or m");
  return metres_each[found - lengths.begin()];
}

double newtons(std::string_view force_unit) {
  const auto* found = std::ranges::find(forces, force_unit);
  core::require(found != forces.end(), "force_unit: expected mN, N or kN");
  return newtons_each[found - forces.begin()];
}

}  // namespace tencer::model
