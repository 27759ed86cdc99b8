// What a scene needs and what is left out: said as it is done.
#include <tencer/equilibrium/system.hpp>
#include <tencer/geometry/frame.hpp>
#include <tencer/model/rest_shape.hpp>
#include <tencer/pipeline/omissions.hpp>

#include "scenes.hpp"

using namespace tencer;
using Catch::Matchers::Contains;

namespace {

pipeline::Feature feature(const model::Scene& scene, const std::string& name) {
  for (const auto& feature : pipeline::features_of(scene, prepared_of(scene)))
    if (feature.name == name) return feature;
  FAIL("no feature " << name);
  return {};
}

int unknowns(const model::Scene& scene) {
  return equilibrium::System(prepared_of(scene).problem.structure).size();
}

Eigen::Matrix3Xd cube_about(const model::Scene& scene) {
  return geometry::enclosing_frame(geometry::FrameShape::cube, scene.target.points[0], 10, false);
}

}  // namespace

TEST_CASE("a round rod in space has positions as unknowns and nothing else") {
  const model::Scene scene = trefoil_scene();
  CHECK(unknowns(scene) == 3 * 40);
  CHECK_FALSE(feature(scene, "theta").used);
  CHECK_THAT(feature(scene, "theta").why, Contains("40 angles fewer"));
  CHECK(feature(scene, "z").used);
  CHECK(feature(scene, "registration").used);
  for (const auto& name : {"loads", "external cables", "symmetry", "outer optimizer"})
    CHECK_FALSE(feature(scene, name).used);
}

TEST_CASE("rods with two axes, bends at rest or a closing angle say what they need") {
  std::vector<geometry::Polyline> rings(4, curves::ellipse(32.5, 25, 30));
  for (int r : {0, 1, 2, 3}) rings[r].points.row(2).array() += 10 * r;
  model::Scene scene = scene_of(rings);
  scene.structure.rods[0].section.EI2 *= 2;
  model::set_rest_shape({.curvature = 0.01}, scene.structure.rods[1]);
  scene.structure.rods[2].closing_angle = 1.0;
  CHECK(unknowns(scene) == 4 * 90 + 30 + 30 + 1);
  const auto theta = feature(scene, "theta");
  CHECK(theta.used);
  CHECK_THAT(theta.why, Contains("two axes: rod A"));
  CHECK_THAT(theta.why, Contains("curved at rest: rod B"));
  CHECK_THAT(theta.why, Contains("rods C and D without"));
  CHECK_THAT(theta.why, Contains("60 angles fewer"));
  CHECK_THAT(theta.why, Contains("closing angle is given: rod C"));
}

TEST_CASE("a planar scene has no z, and a flat one that is not said to be planar has") {
  model::Scene scene = ellipse_scene();
  CHECK(unknowns(scene) == 90);
  CHECK(feature(scene, "z").used);
  CHECK_THAT(feature(scene, "z").why, Contains("planar = true is not said"));
  scene.structure.planar = true;
  CHECK(unknowns(scene) == 60);
  CHECK_FALSE(feature(scene, "z").used);
  CHECK_THAT(feature(scene, "z").why, Contains("30 unknowns fewer"));
}

TEST_CASE("what is held needs no registration") {
  model::Scene scene = ellipse_scene();
  SECTION("by pins") {
    scene.structure.pins = {{.rod = 0, .vertex = 3}};
    CHECK(unknowns(scene) == 87);
    CHECK_FALSE(prepared_of(scene).problem.target.align);
    CHECK_FALSE(feature(scene, "registration").used);
    CHECK_THAT(feature(scene, "pinned coordinates").why, Contains("3 unknowns fewer"));
    CHECK_FALSE(feature(scene, "hand-over").used);
    scene.design.hand_over = true;
    scene.structure.anchors = cube_about(scene);
    CHECK(feature(scene, "hand-over").used);
  }
  SECTION("by anchors") {
    scene.structure.anchors = cube_about(scene);
    CHECK_FALSE(prepared_of(scene).problem.target.align);
    CHECK_FALSE(feature(scene, "registration").used);
    CHECK(feature(scene, "external cables").used);
    scene.rules.external = false;
    CHECK(prepared_of(scene).problem.target.align);
    CHECK(feature(scene, "registration").used);
    CHECK_FALSE(feature(scene, "external cables").used);
    CHECK(feature(scene, "external cables").why == "external = false");
  }
}

TEST_CASE("symmetry is used where it is asked for, there, and can be kept") {
  model::Scene scene = ellipse_scene(32);
  CHECK_FALSE(prepared_of(scene).problem.symmetry);
  scene.design.symmetry = model::SymmetryUse::detect;
  const auto group = prepared_of(scene).problem.symmetry;
  REQUIRE(group);
  CHECK(feature(scene, "symmetry").used);
  CHECK_THAT(feature(scene, "symmetry").why,
             Contains(std::to_string(group->order()) + " operations"));

  scene.design.method = model::Method::dense_springs;
  CHECK_FALSE(prepared_of(scene).problem.symmetry);
  CHECK_FALSE(feature(scene, "symmetry").used);
  CHECK_THAT(feature(scene, "symmetry").why, Contains("does not keep it"));
  CHECK(feature(scene, "outer optimizer").used);

  scene.design.method = model::Method::force_balance;
  Eigen::Matrix3Xd points = scene.target.points[0];
  points.col(5) += Eigen::Vector3d(3, 1, 2);
  retarget(scene, 0, points);
  CHECK_FALSE(prepared_of(scene).problem.symmetry);
  CHECK_THAT(feature(scene, "symmetry").why, Contains("have none"));
}
