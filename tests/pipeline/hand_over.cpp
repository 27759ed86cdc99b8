// Pins handed over to cables in a design.
#include "fixtures/cube.hpp"
#include "fixtures/elastica.hpp"
#include "scenes.hpp"

using namespace tencer;
using fixtures::elastica;

namespace {

// 100 long, to be handed over from its hinges to four anchors.
model::Scene arc_scene(double angle) {
  model::Scene scene = scene_of({{.points = 100 * elastica(40, angle).x, .closed = false}});
  scene.structure.planar = true;
  scene.structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 39}};
  scene.structure.anchors.resize(3, 4);
  scene.structure.anchors << -20, 110, 110, -20, -20, -20, 60, 60, 0, 0, 0, 0;
  scene.rules.external = false;
  scene.design.hand_over = true;
  scene.build.layers = true;
  return scene;
}

}  // namespace

TEST_CASE("a design whose pins are handed over stands without them") {
  const double angle = 1.0;
  const model::Scene scene = arc_scene(angle);
  const model::Design design = designed(scene);
  CHECK(model::shortfalls(design) == std::vector<std::string>{});
  CHECK(design.structure.pins.empty());
  CHECK(design.error->max_percent <= 1);
  CHECK(
      std::ranges::any_of(design.trace, [](const auto& row) { return row.stage == "hand-over"; }));
  REQUIRE_FALSE(design.structure.cables.empty());
  Eigen::Vector3d on_left = Eigen::Vector3d::Zero();
  for (std::size_t c = 0; c < design.built.size(); ++c) {
    const springs::Cable& cable = design.structure.cables[c];
    CHECK(model::is_external(cable));
    const Eigen::Vector3d from = end_point(design, cable.a);
    if (from.x() > 40) continue;
    on_left += design.built[c].tension * (end_point(design, cable.b) - from).normalized();
  }
  const double load = elastica(2, angle).load * scene.structure.rods[0].section.EI1 / 1e4;
  CHECK(on_left.x() == Approx(load).epsilon(0.05));
  CHECK(std::abs(on_left.y()) < 0.05 * load);
}

TEST_CASE("a number of cables counts those in place of pins, and all numbers are without pins") {
  model::Scene scene = arc_scene(1.0);
  SECTION("a number") {
    scene.design.cables = 4;
    const model::Design design = designed(scene);
    CHECK(model::shortfalls(design) == std::vector<std::string>{});
    CHECK(design.structure.cables.size() <= 4);
    CHECK(design.structure.pins.empty());
  }
  SECTION("all numbers") {
    const auto designs = pipeline::trade_off(scene);
    REQUIRE(designs);
    for (const model::Design& design : *designs) {
      CHECK(design.structure.pins.empty());
      CHECK(std::ranges::any_of(design.structure.cables, model::is_external));
    }
  }
}

TEST_CASE("an end that a pin does not pull at is just let go") {
  // A straight rod: nothing to take over, and no cables.
  Eigen::Matrix3Xd line = Eigen::Matrix3Xd::Zero(3, 10);
  for (int i = 0; i < 10; ++i) line(0, i) = i;
  model::Scene scene = scene_of({{.points = line, .closed = false}});
  scene.structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 9}};
  scene.structure.anchors = cube(20);
  scene.rules.external = false;
  scene.design.hand_over = true;
  const model::Design design = designed(scene);
  CHECK(design.structure.cables.empty());
  CHECK(design.structure.pins.empty());
  CHECK(design.status == model::DesignStatus::complete);
}

TEST_CASE("anchors have to surround the pins that they take over") {
  model::Scene scene = scene_of({{.points = 100 * elastica(20, 1.0).x, .closed = false}});
  scene.structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 19}};
  scene.structure.anchors = cube(50).colwise() + Eigen::Vector3d(40, 20, 0);
  scene.design.hand_over = true;
  CHECK(error_of(scene) == "no error");
  SECTION("beside them") {
    scene.structure.anchors.row(0).array() += 20;
    CHECK_THAT(error_of(scene),
               Catch::Matchers::StartsWith("small.obj: design.hand_over: the anchors must surround "
                                           "every pinned vertex, but vertex 0 of the rod is not"));
  }
  SECTION("out of reach") {
    scene.rules.max_cable_length = 60;
    CHECK_THAT(error_of(scene), Catch::Matchers::Contains("that the longest cable reaches"));
  }
}
