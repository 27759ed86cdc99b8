#include <algorithm>
#include <numbers>
#include <string_view>
#include <tencer/core/error.hpp>
#include <tencer/io/scene.hpp>

#include "scene_units.hpp"

namespace tencer::io {
namespace {

double size_of(const auto& names, const auto& sizes, std::string_view unit) {
  const auto found = std::ranges::find(names, unit);
  core::require(found != names.end(), "glass_fibre_modulus: unknown unit");
  return sizes[found - names.begin()];
}

}  // namespace

Section circular_section(double radius, double youngs_modulus, double poisson) {
  core::require(radius > 0 && youngs_modulus > 0 && poisson > -1 && poisson <= 0.5,
                "circular_section: radius and modulus are positive, poisson in (-1, 0.5]");
  const double area = std::numbers::pi * radius * radius;
  const double EI = youngs_modulus * area * radius * radius / 4.0;
  // G J = E / (2 (1 + nu)) * (pi r^4 / 2)
  return {youngs_modulus * area, {EI, EI}, EI / (1.0 + poisson)};
}

double glass_fibre_modulus(const std::string& length_unit, const std::string& force_unit) {
  const double length = size_of(length_units, metres, length_unit);
  return 40e9 / size_of(force_units, newtons, force_unit) * (length * length);
}

}  // namespace tencer::io
