// A scene at another resolution is ready to be designed.
#include <tencer/model/resolution.hpp>

#include "scenes.hpp"

using namespace tencer;

TEST_CASE("a scene at another resolution can be prepared") {
  model::Scene scene = ellipse_scene();
  scene.structure.planar = true;
  scene.structure.pins = {{.rod = 0, .vertex = 29}, {.rod = 0, .vertex = 0}};
  const double length = scene.structure.rods[0].length();
  scene.structure.point_loads = {{.rod = 0, .s = length / 2, .force = {0, -1, 0}}};
  scene.rules.forbidden = {{0, length / 4, length / 3}};
  scene.target.weights[0].tail(15).setConstant(3);
  for (const double times : {0.5, 3.0}) {
    const auto prepared = pipeline::prepare(model::at_resolution(scene, times));
    if (!prepared) FAIL(prepared.error().text());
    CHECK(prepared->problem.structure.rods[0].vertices() == static_cast<int>(30 * times));
  }
}
