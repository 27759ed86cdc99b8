// Cross-sections: the four stiffnesses a rod needs, and the shape that they come from.
#pragma once

#include <optional>
#include <variant>

namespace tencer::der {

// Sizes are lengths.
struct Circle {
  double radius = 0.0;
};
struct Tube {
  double outer_radius = 0.0;
  double inner_radius = 0.0;
};
struct Rectangle {
  double width = 0.0;   // along m1
  double height = 0.0;  // along m2
};

// Without one only stiffnesses are known.
using Shape = std::variant<std::monostate, Circle, Tube, Rectangle>;

// In units of length squared; not set without a shape.
std::optional<double> area(const Shape& shape);

// Half of the section's size along m1 and along m2: its outer fibres. Not set without a shape.
struct HalfSizes {
  double along_m1 = 0.0;
  double along_m2 = 0.0;
};
std::optional<HalfSizes> half_sizes(const Shape& shape);

// The largest strain of any fibre of a section that a bend turns towards m1 and m2 by these
// curvatures (1 / length), beyond those at rest. Not set without a shape.
std::optional<double> bending_strain(const Shape& shape, double towards_m1, double towards_m2);

// The shape with its sizes `factor` times as large.
Shape resized(Shape shape, double factor);

// EA in force; EI and GJ in force times length squared. EI1 resists curvature about the material
// axis m1, EI2 about m2 (principal axes of the section).
struct Section {
  double EA = 1.0;
  double EI1 = 1.0;
  double EI2 = 1.0;
  double GJ = 1.0;
  Shape shape{};

  bool isotropic() const { return EI1 == EI2; }
};

// These keep their shape. youngs_modulus: force per length squared; poisson in (-1, 0.5]; sizes are
// lengths. All throw std::invalid_argument, saying what is wrong, for values out of range, and for
// an inner radius that is negative or not less than the outer one.
Section solid_circle(double youngs_modulus, double poisson, double radius);
Section tube(double youngs_modulus, double poisson, double outer_radius, double inner_radius);
// width along m1, height along m2; GJ by Saint-Venant's series for a rectangle.
Section rectangle(double youngs_modulus, double poisson, double width, double height);

}  // namespace tencer::der
