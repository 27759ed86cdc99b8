// What a scene needs and what is left out: said as it is done.
#include <tencer/equilibrium/system.hpp>
#include <tencer/geometry/frame.hpp>
#include <tencer/pipeline/prepare.hpp>

#include "scenes.hpp"

using namespace tencer;
using Catch::Matchers::Contains;

namespace {

pipeline::Part part(const pipeline::Prepared& prepared, const std::string& name) {
  for (const auto& part : prepared.parts)
    if (part.name == name) return part;
  FAIL("no part " << name);
  return {};
}

int unknowns(const pipeline::Prepared& prepared) {
  return equilibrium::System(prepared.structure).size();
}

}  // namespace

TEST_CASE("a round rod in space has positions as unknowns and nothing else") {
  const auto prepared = prepared_of(trefoil_scene());
  CHECK(unknowns(prepared) == 3 * 40);
  CHECK_FALSE(part(prepared, "theta").used);
  CHECK_THAT(part(prepared, "theta").why, Contains("40 angles fewer"));
  CHECK(part(prepared, "z").used);
  CHECK(part(prepared, "registration").used);
  for (const auto& name : {"loads", "external cables", "symmetry", "outer optimizer"})
    CHECK_FALSE(part(prepared, name).used);
}

TEST_CASE("rods with two axes, bends at rest or a closing angle say what they need") {
  std::vector<geometry::Polyline> rings(4, curves::ellipse(32.5, 25, 30));
  for (int r : {0, 1, 2, 3}) rings[r].points.row(2).array() += 10 * r;
  io::Scene scene = scene_of(rings);
  scene.rods[0].section.EI[1] *= 2;
  scene.rods[1].rest.curvature = 0.01;
  scene.rods[2].closing_angle = 1.0;
  const auto prepared = prepared_of(scene);
  CHECK(unknowns(prepared) == 4 * 90 + 30 + 30 + 1);
  const auto theta = part(prepared, "theta");
  CHECK(theta.used);
  CHECK_THAT(theta.why, Contains("two axes, rod 0"));
  CHECK_THAT(theta.why, Contains("curved at rest, rod 1"));
  CHECK_THAT(theta.why, Contains("rods 2, 3 without"));
  CHECK_THAT(theta.why, Contains("60 angles fewer"));
  CHECK_THAT(theta.why, Contains("closing angle is given, rod 2"));
}

TEST_CASE("a planar scene has no z, and a flat one that is not said to be planar has") {
  io::Scene scene = ellipse_scene();
  const auto flat = prepared_of(scene);
  CHECK(unknowns(flat) == 90);
  CHECK(part(flat, "z").used);
  CHECK_THAT(part(flat, "z").why, Contains("planar = true is not said"));
  scene.planar = true;
  const auto planar = prepared_of(scene);
  CHECK(unknowns(planar) == 60);
  CHECK_FALSE(part(planar, "z").used);
  CHECK_THAT(part(planar, "z").why, Contains("30 unknowns fewer"));
}

TEST_CASE("what is held needs no registration") {
  io::Scene scene = ellipse_scene();
  SECTION("by pins") {
    scene.pinned = {{.rod = 0, .vertex = 3}};
    const auto prepared = prepared_of(scene);
    CHECK(unknowns(prepared) == 87);
    CHECK_FALSE(prepared.target.align);
    CHECK_FALSE(part(prepared, "registration").used);
    CHECK_THAT(part(prepared, "pinned coordinates").why, Contains("3 unknowns fewer"));
    CHECK_FALSE(part(prepared, "hand-over").used);
    scene.design.hand_over = true;
    scene.anchors = geometry::enclosing_frame(geometry::FrameShape::cube,
                                              scene.rods[0].target.points, 10, false);
    CHECK(part(prepared_of(scene), "hand-over").used);
  }
  SECTION("by anchors") {
    scene.anchors = geometry::enclosing_frame(geometry::FrameShape::cube,
                                              scene.rods[0].target.points, 10, false);
    auto prepared = prepared_of(scene);
    CHECK_FALSE(prepared.target.align);
    CHECK_FALSE(part(prepared, "registration").used);
    CHECK(part(prepared, "external cables").used);
    scene.design.external = false;
    prepared = prepared_of(scene);
    CHECK(prepared.target.align);
    CHECK(part(prepared, "registration").used);
    CHECK_FALSE(part(prepared, "external cables").used);
    CHECK(part(prepared, "external cables").why == "external = false");
  }
}

TEST_CASE("symmetry is used where it is asked for, there, and can be kept") {
  io::Scene scene = ellipse_scene(32);
  CHECK_FALSE(prepared_of(scene).symmetry);
  scene.design.symmetry = "detect";
  auto prepared = prepared_of(scene);
  REQUIRE(prepared.symmetry);
  CHECK(part(prepared, "symmetry").used);
  CHECK_THAT(part(prepared, "symmetry").why,
             Contains(std::to_string(prepared.symmetry->order()) + " operations"));

  scene.design.method = "dense-springs";
  prepared = prepared_of(scene);
  CHECK_FALSE(prepared.symmetry);
  CHECK_FALSE(part(prepared, "symmetry").used);
  CHECK_THAT(part(prepared, "symmetry").why, Contains("does not keep it"));
  CHECK(part(prepared, "outer optimizer").used);

  scene.design.method = "force-balance";
  scene.rods[0].target.points.col(5) += Eigen::Vector3d(3, 1, 2);
  prepared = prepared_of(scene);
  CHECK_FALSE(prepared.symmetry);
  CHECK_THAT(part(prepared, "symmetry").why, Contains("have none"));
}
