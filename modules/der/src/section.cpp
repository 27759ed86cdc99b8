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

// A function for each kind of shape.
template <class... F>
struct Cases : F... {
  using F::operator()...;
};
// clang 14 does not deduce the arguments of an aggregate without being told.
template <class... F>
Cases(F...) -> Cases<F...>;

double ring_area(double outer, double inner) {
  return std::numbers::pi * (outer * outer - inner * inner);
}

}  // namespace

std::optional<double> area(const Shape& shape) {
  using Area = std::optional<double>;
  return std::visit(
      Cases{[](std::monostate) { return Area(); },
            [](const Circle& circle) { return Area(ring_area(circle.radius, 0.0)); },
            [](const Tube& tube) { return Area(ring_area(tube.outer_radius, tube.inner_radius)); },
            [](const Rectangle& rectangle) { return Area(rectangle.width * rectangle.height); }},
      shape);
}

std::optional<HalfSizes> half_sizes(const Shape& shape) {
  using Sizes = std::optional<HalfSizes>;
  return std::visit(Cases{[](std::monostate) { return Sizes(); },
                          [](const Circle& circle) {
                            return Sizes({circle.radius, circle.radius});
                          },
                          [](const Tube& tube) {
                            return Sizes({tube.outer_radius, tube.outer_radius});
                          },
                          [](const Rectangle& rectangle) {
                            return Sizes({rectangle.width / 2, rectangle.height / 2});
                          }},
                    shape);
}

std::optional<double> bending_strain(const Shape& shape, double towards_m1, double towards_m2) {
  const auto half = half_sizes(shape);
  if (!half) return std::nullopt;
  const double along_m1 = half->along_m1 * std::abs(towards_m1);
  const double along_m2 = half->along_m2 * std::abs(towards_m2);
  // The outermost fibre of a rectangle is at a corner.
  return std::holds_alternative<Rectangle>(shape) ? along_m1 + along_m2
                                                  : std::hypot(along_m1, along_m2);
}

Shape resized(Shape shape, double factor) {
  std::visit(Cases{[](std::monostate) {}, [&](Circle& circle) { circle.radius *= factor; },
                   [&](Tube& tube) {
                     tube.outer_radius *= factor;
                     tube.inner_radius *= factor;
                   },
                   [&](Rectangle& rectangle) {
                     rectangle.width *= factor;
                     rectangle.height *= factor;
                   }},
             shape);
  return shape;
}

Section solid_circle(double youngs_modulus, double poisson, double radius) {
  Section section = tube(youngs_modulus, poisson, radius, 0.0);
  section.shape = Circle{radius};
  return section;
}

Section tube(double youngs_modulus, double poisson, double outer_radius, double inner_radius) {
  core::require(inner_radius >= 0 && outer_radius > inner_radius,
                "section: needs 0 <= inner radius < outer radius");
  const double shear = shear_modulus(youngs_modulus, poisson);
  const double a2 = outer_radius * outer_radius;
  const double b2 = inner_radius * inner_radius;
  const double inertia = std::numbers::pi / 4 * (a2 * a2 - b2 * b2);
  return {.EA = youngs_modulus * ring_area(outer_radius, inner_radius),
          .EI1 = youngs_modulus * inertia,
          .EI2 = youngs_modulus * inertia,
          .GJ = shear * 2 * inertia,
          .shape = Tube{outer_radius, inner_radius}};
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
          .GJ = shear * torsion,
          .shape = Rectangle{width, height}};
}

}  // namespace tencer::der
