// Cross-sections as the four stiffnesses a rod needs.
#pragma once

namespace tencer::der {

// EA in force; EI and GJ in force times length squared. EI1 resists curvature about the material
// axis m1, EI2 about m2 (principal axes of the section).
struct Section {
  double EA = 1.0;
  double EI1 = 1.0;
  double EI2 = 1.0;
  double GJ = 1.0;

  bool isotropic() const { return EI1 == EI2; }
};

// youngs_modulus: force per length squared; poisson in (-1, 0.5]; sizes are lengths. All throw
// std::invalid_argument, saying what is wrong, for values out of range, and for an inner radius
// that is negative or not less than the outer one.
Section solid_circle(double youngs_modulus, double poisson, double radius);
Section tube(double youngs_modulus, double poisson, double outer_radius, double inner_radius);
// width along m1, height along m2; GJ by Saint-Venant's series for a rectangle.
Section rectangle(double youngs_modulus, double poisson, double width, double height);

}  // namespace tencer::der
