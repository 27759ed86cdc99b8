#include <cmath>
#include <numbers>
#include <tencer/core/error.hpp>
#include <tencer/der/section.hpp>
#include <utility>

namespace tencer::der {
namespace {

double shear_modulus(double youngs_modulus, double poisson) {
  core::require(youngs_modulus > 0 && std::isfinite(youngs_modulus),
                "section: Young's modulus must be positive");
  core::require(poisson > -1 && poisson <= 0.5, "section: Poisson's ratio must be in (-1, 0.5]");
  return youngs_modulus / (2 * (1 + poisson));
}

}  // namespace

Section solid_circle(double youngs_modulus, double poisson, double radius) {
  return tube(youngs_modulus, poisson, radius, 0.0);
}

Section tube(double youngs_modulus, double poisson, double outer_radius, double inner_radius) {
  core::require(inner_radius >= 0 && outer_radius > inner_radius,
                "section: needs 0 <= inner radius < outer radius");
  const double shear = shear_modulus(youngs_modulus, poisson);
  const double a2 = outer_radius * outer_radius;
  const double b2 = inner_radius * inner_radius;
  const double area = std::numbers::pi * (a2 - b2);
  const double inertia = std::numbers::pi / 4 * (a2 * a2 - b2 * b2);
  return {.EA = youngs_modulus * area,
          .EI1 = youngs_modulus * inertia,
          .EI2 = youngs_modulus * inertia,
          .GJ = shear * 2 * inertia};
}

Section rectangle(double youngs_modulus, double poisson, double width, double height) {
  core::require(width > 0 && height > 0, "section: width and height must be positive");
  const double shear = shear_modulus(youngs_modulus, poisson);
  double a = width;
  double b = height;
  if (a < b) std::swap(a, b);
  // Saint-Venant: J = a b^3 (1/3 - 64/pi^5 (b/a) sum_{k odd} tanh(k pi a / 2b) / k^5).
  double sum = 0;
  for (int k = 1; k <= 201; k += 2)
    sum += std::tanh(k * std::numbers::pi * a / (2 * b)) / std::pow(k, 5);
  const double torsion =
      a * b * b * b * (1.0 / 3 - 64 / std::pow(std::numbers::pi, 5) * b / a * sum);
  return {.EA = youngs_modulus * width * height,
          .EI1 = youngs_modulus * width * height * height * height / 12,
          .EI2 = youngs_modulus * height * width * width * width / 12,
          .GJ = shear * torsion};
}

}  // namespace tencer::der
