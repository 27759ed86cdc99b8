#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/model/scaling.hpp>
#include <tencer/model/scene.hpp>
#include <tencer/model/strain.hpp>

using namespace tencer;

namespace {

geometry::Polyline ellipse(double a, double b, int vertices) {
  geometry::Polyline curve{Eigen::Matrix3Xd(3, vertices), true};
  for (int i = 0; i < vertices; ++i) {
    const double t = 2 * std::numbers::pi * i / vertices;
    curve.points.col(i) << a * std::sin(t), b * std::cos(t), 0.0;
  }
  return curve;
}

// A round rod at rest along a straight line, bent to the ellipse.
model::Scene ellipse_of(const der::Section& section) {
  model::Scene scene;
  add_rod(scene, ellipse(40, 20, 1000));
  scene.structure.rods[0].section = section;
  return scene;
}

}  // namespace

TEST_CASE("the strain of a rod on an ellipse is largest at the end of its long axis") {
  const model::Scene scene = ellipse_of(der::solid_circle(1e6, 0.3, 0.1));
  const auto strains =
      largest_bending_strains(scene.structure, make_state(scene.structure, scene.target.points));
  REQUIRE(strains.size() == 1);
  REQUIRE(strains[0]);
  const double curvature = 40.0 / (20 * 20);
  CHECK(strains[0]->curvature == Approx(curvature).epsilon(1e-3));
  CHECK(strains[0]->strain == Approx(0.1 * curvature).epsilon(1e-3));
  const double quarter = scene.structure.rods[0].length() / 4;
  CHECK(std::remainder(strains[0]->s - quarter, 2 * quarter) == Approx(0).margin(1e-6));
  CHECK((strains[0]->vertex == 250 || strains[0]->vertex == 750));
}

TEST_CASE("strain has no unit: it is the same in scaled units") {
  const model::Scene scene = ellipse_of(der::tube(1e6, 0.3, 0.1, 0.05));
  const model::Scaling scaling = scaling_of(scene.structure, scene.target.points);
  const model::Structure structure = scaled(scene.structure, scaling);
  const auto here =
      largest_bending_strains(scene.structure, make_state(scene.structure, scene.target.points));
  const auto there = largest_bending_strains(
      structure, make_state(structure, scaled(scene.target.points, scaling)));
  CHECK(there[0]->strain == Approx(here[0]->strain));
  CHECK(there[0]->s * scaling.scale.length == Approx(here[0]->s));
}

TEST_CASE("without a shape the strain of a rod is not known") {
  const model::Scene scene = ellipse_of({});
  CHECK_FALSE(largest_bending_strains(scene.structure,
                                      make_state(scene.structure, scene.target.points))[0]);
}
