#include <catch2/catch.hpp>
#include <numbers>
#include <stdexcept>
#include <tencer/der/section.hpp>

using namespace tencer::der;
using std::numbers::pi;

TEST_CASE("circle and tube") {
  const double E = 200.0;
  const double r = 0.3;
  const Section solid = solid_circle(E, 0.25, r);
  CHECK(solid.EA == Approx(E * pi * r * r));
  CHECK(solid.EI1 == Approx(E * pi * std::pow(r, 4) / 4));
  CHECK(solid.isotropic());
  CHECK(solid.GJ == Approx(E / 2.5 * pi * std::pow(r, 4) / 2));
  const Section hollow = tube(E, 0.25, r, 0.2);
  const Section core = solid_circle(E, 0.25, 0.2);
  CHECK(hollow.EA == Approx(solid.EA - core.EA));
  CHECK(hollow.EI2 == Approx(solid.EI2 - core.EI2));
  CHECK(hollow.GJ == Approx(solid.GJ - core.GJ));
}

TEST_CASE("the torsion constant of rectangles") {
  const double poisson = 0.5;  // G = E / 3
  CHECK(3 * rectangle(1.0, poisson, 2.0, 2.0).GJ == Approx(0.140577 * 16).epsilon(1e-5));
  CHECK(3 * rectangle(1.0, poisson, 2.0, 1.0).GJ == Approx(0.228682 * 2).epsilon(1e-5));
  // A thin strip, with its end correction.
  CHECK(3 * rectangle(1.0, poisson, 1.0, 1e-3).GJ ==
        Approx(1e-9 / 3 * (1 - 0.630249e-3)).epsilon(1e-8));
}

TEST_CASE("a rectangle is stiffer about the axis along its width") {
  const Section flat = rectangle(12.0, 0.3, 2.0, 0.5);  // 2 along m1
  CHECK(flat.EI1 == Approx(2.0 * 0.125));
  CHECK(flat.EI2 == Approx(0.5 * 8));
  const Section upright = rectangle(12.0, 0.3, 0.5, 2.0);
  CHECK(upright.EI1 == flat.EI2);
  CHECK(upright.EI2 == flat.EI1);
  CHECK(upright.GJ == flat.GJ);
}

TEST_CASE("a section keeps its shape: area, outer fibres and strain of a bend") {
  const Shape circle = solid_circle(1.0, 0.3, 0.5).shape;
  CHECK(*area(circle) == Approx(pi / 4));
  CHECK(*bending_strain(circle, 0.03, 0.04) == Approx(0.025));
  const Shape hollow = tube(1.0, 0.3, 0.5, 0.4).shape;
  CHECK(*area(hollow) == Approx(pi * 0.09));
  CHECK(*bending_strain(hollow, 0.03, -0.04) == Approx(0.025));
  const Shape strip = rectangle(1.0, 0.3, 0.2, 4.0).shape;
  CHECK(*area(strip) == Approx(0.8));
  CHECK(*bending_strain(strip, -0.1, 0.0) == Approx(0.01));
  CHECK(*bending_strain(strip, 0.0, 0.1) == Approx(0.2));
  CHECK(*bending_strain(strip, 0.1, -0.1) == Approx(0.21));  // at a corner
  const auto grown = half_sizes(resized(strip, 10));
  CHECK(grown->along_m1 == Approx(1.0));
  CHECK(grown->along_m2 == Approx(20.0));
  const Shape none = Section{}.shape;
  CHECK_FALSE(area(none));
  CHECK_FALSE(half_sizes(none));
  CHECK_FALSE(bending_strain(none, 1.0, 1.0));
}

TEST_CASE("sections that cannot be are refused") {
  CHECK_THROWS_AS(solid_circle(0.0, 0.3, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(solid_circle(1.0, 0.6, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(solid_circle(1.0, 0.3, -1.0), std::invalid_argument);
  CHECK_THROWS_AS(tube(1.0, 0.3, 1.0, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(rectangle(1.0, 0.3, 0.0, 1.0), std::invalid_argument);
}
