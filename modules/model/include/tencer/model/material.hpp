// What rods are made of: stiffness, weight, and how far they can be bent.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tencer/der/section.hpp>

namespace tencer::model {

struct Material {
  std::string name{};
  double youngs_modulus = 0.0;      // Pa
  std::optional<double> density{};  // kg/m^3
  double strain_limit = 0.0;        // of a bend that is held for years
  double breaking_strain = 0.0;     // where it breaks, or a metal yields
  std::string source{};             // of these figures
};

// Those that are known, glass fibre first.
std::span<const Material> materials();

// Not set: none has this name.
std::optional<Material> find_material(std::string_view name);

// Pultruded glass fibre (E as in table 1 of the paper), what rods are made of when nothing is said.
const Material& glass_fibre();

// Young's modulus in the force unit over the length unit squared; units as in units.hpp.
double youngs_modulus_in(const Material& material, std::string_view length_unit,
                         std::string_view force_unit);

// kg/m of a rod of this shape, whose sizes are in the length unit; not set without a density or a
// shape.
std::optional<double> mass_per_length(const Material& material, const der::Shape& shape,
                                      std::string_view length_unit);

}  // namespace tencer::model
