#include <algorithm>
#include <tencer/model/material.hpp>
#include <tencer/model/units.hpp>
#include <vector>

namespace tencer::model {
namespace {

constexpr const char* handbook = "typical handbook value";

const std::vector<Material>& known() {
  static const std::vector<Material> all{
      {"glass fibre", 40e9, 1900.0, 0.010, 0.020,
       "E from table 1 of the paper; pultruded rods break near 2 %, builders allow 1 % for long"},
      {"carbon", 130e9, 1600.0, 0.006, 0.012, handbook},
      {"ash", 12e9, 680.0, 0.005, 0.010, handbook},
      {"beech", 13e9, 720.0, 0.0045, 0.009, handbook},
      {"spruce", 11e9, 450.0, 0.0035, 0.007, handbook},
      {"bamboo", 18e9, 700.0, 0.005, 0.010, handbook},
      {"spring steel", 206e9, 7850.0, 0.005, 0.007, handbook},
      {"stainless steel", 193e9, 7900.0, 0.003, 0.005, handbook},  // hard drawn
      {"aluminium", 69e9, 2700.0, 0.0025, 0.004, handbook},        // alloys of series 6000
      {"brass", 105e9, 8500.0, 0.002, 0.0035, handbook}};          // hard drawn
  return all;
}

}  // namespace

std::span<const Material> materials() { return known(); }

std::optional<Material> find_material(std::string_view name) {
  const auto found = std::ranges::find(known(), name, &Material::name);
  return found == known().end() ? std::nullopt : std::optional(*found);
}

const Material& glass_fibre() { return known().front(); }

double youngs_modulus_in(const Material& material, std::string_view length_unit,
                         std::string_view force_unit) {
  const double length = metres(length_unit);
  return material.youngs_modulus / newtons(force_unit) * (length * length);
}

std::optional<double> mass_per_length(const Material& material, const der::Shape& shape,
                                      std::string_view length_unit) {
  const auto area = der::area(shape);
  if (!area || !material.density) return std::nullopt;
  const double metre = metres(length_unit);
  return *material.density * *area * metre * metre;
}

}  // namespace tencer::model
