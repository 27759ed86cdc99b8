// Rods that break, or cannot be bent so far, are told apart from those that can be built.
#include <numbers>
#include <tencer/curves/analytic.hpp>
#include <tencer/model/strain.hpp>

#include "scenes.hpp"

using namespace tencer;

namespace {

// An ellipse with a radius of curvature of 10 cm at its ends, of glass fibre.
model::Scene ellipse(double radius) {
  model::Scene scene = scene_of({curves::ellipse(40, 20, 60)});
  scene.structure.rods[0].section = der::solid_circle(4e6, 0.3, radius);
  return scene;
}

struct Said {
  std::vector<std::string> warnings;
};

model::Design designed(const model::Scene& scene, Said& said) {
  const auto design =
      pipeline::design(scene, {.log = [&](core::Level level, std::string_view text) {
                         if (level == core::Level::warning) said.warnings.emplace_back(text);
                       }});
  if (!design) FAIL(design.error().text());
  return *design;
}

}  // namespace

TEST_CASE("nothing is said against a rod within its limit, and the design is complete") {
  Said said;
  const model::Design design = designed(ellipse(0.05), said);
  CHECK(design.complete());
  CHECK(said.warnings.empty());
  REQUIRE(design.strains.size() == 1);
  // The pose is a little rounder than the target, whose strain is 0.5 %.
  CHECK(design.strains[0]->strain > 0.004);
  CHECK(design.strains[0]->strain < 0.0055);
}

TEST_CASE("a rod that does not hold for long is told before the search, and can be built") {
  Said said;
  CHECK(designed(ellipse(0.15), said).complete());
  REQUIRE(said.warnings.size() == 1);
  CHECK_THAT(said.warnings[0], Catch::Contains("the rod is bent to a strain of 1.49 %") &&
                                   Catch::Contains("glass fibre holds for long 1 %; a radius of "
                                                   "0.101 cm would do"));
}

TEST_CASE("a rod that breaks is told before the search, and the design is not complete") {
  Said said;
  const model::Design design = designed(ellipse(0.3), said);
  REQUIRE(said.warnings.size() == 1);
  CHECK_THAT(said.warnings[0], Catch::Contains("the rod is bent to a strain of 2.98 %") &&
                                   Catch::Contains("glass fibre breaks at 2 %; a radius of 0.101"));
  CHECK(design.status == model::DesignStatus::tolerance_not_reached);
  REQUIRE(model::shortfalls(design).size() == 1);
  CHECK_THAT(model::shortfalls(design)[0], Catch::Contains("the rod is bent to a strain of 2."));
  // What the cables are does not depend on it.
  CHECK(design.certificate->stable);
  CHECK(design.error->max_percent < 1);
}

TEST_CASE("a rod thicker than its bends are wide is refused") {
  const auto refused = pipeline::prepare(ellipse(12));
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().text(),
             Catch::Contains("the rod is thicker than its bends are wide: at arc length") &&
                 Catch::Contains("cm the curve has a radius of 10"));
}

TEST_CASE("without the section's shape or a material no strain is judged") {
  Said said;
  model::Scene scene = ellipse(0.3);
  scene.structure.rods[0].section.shape = {};
  CHECK(designed(scene, said).complete());
  scene = ellipse(0.3);
  scene.structure.materials.clear();
  CHECK(designed(scene, said).complete());
  CHECK(said.warnings.empty());
}

TEST_CASE("corners are told, with the place, and a design with them is not complete") {
  Said said;
  // Five sides of a hexagon whose last is bent up, each of four edges.
  geometry::Polyline bent{.points = Eigen::Matrix3Xd::Zero(3, 21), .closed = false};
  for (int i = 1; i <= 20; ++i) {
    const double angle = (i - 1) / 4 * std::numbers::pi / 3;
    bent.points.col(i) =
        bent.points.col(i - 1) +
        Eigen::Vector3d(std::cos(angle), std::sin(angle), i > 16 ? 0.5 : 0.0).normalized();
  }
  const model::Design design = designed(scene_of({bent}), said);
  REQUIRE(said.warnings.size() == 1);
  CHECK_THAT(
      said.warnings[0],
      Catch::StartsWith("the rod has a corner at arc length 4 cm, (4, 0, 0), where it turns by "
                        "60 degrees from one edge to the next, and 3 more: no rod follows "
                        "it (this one, of glass fibre, bends to a radius of 2 cm at the "
                        "least)"));
  CHECK_THAT(model::shortfalls(design), Catch::VectorContains(said.warnings[0]));
  CHECK_FALSE(design.complete());
}

TEST_CASE("a rough target is told") {
  geometry::Polyline rough = curves::ellipse(40, 20, 60);
  for (int i = 0; i < 60; ++i) rough.points(2, i) += i % 2 == 0 ? 0.4 : -0.4;
  const model::Scene scene = scene_of({rough});
  CHECK_THAT(model::bend_problem(scene.structure, 0, scene.target.points[0], {}, "cm").value_or(""),
             Catch::Contains("the rod has a rough target"));
}

TEST_CASE("edges that differ too much are named") {
  geometry::Polyline uneven = curves::ellipse(40, 20, 60);
  uneven.points.col(11) =
      uneven.points.col(10) + (uneven.points.col(11) - uneven.points.col(10)) / 2000;
  const auto refused = pipeline::prepare(scene_of({uneven}));
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().text(),
             Catch::Contains("the rod has edges too uneven: from vertex 10"));
}
