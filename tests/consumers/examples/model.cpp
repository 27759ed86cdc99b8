#include <iostream>
#include <tencer/model/scene.hpp>

int main() {
  using namespace tencer;
  geometry::Polyline arc{.points = Eigen::Matrix3Xd::Zero(3, 5), .closed = false};
  arc.points.row(0) << 0, 10, 20, 30, 40;  // cm
  arc.points.row(1) << 0, 3, 4, 3, 0;
  model::Scene scene = model::scene_of({arc}, "arch");
  scene.structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 4}};
  model::validate(scene.structure);  // throws, naming what is wrong
  std::cout << model::total_length(scene.structure) << ' ' << scene.length_unit << " of rod, EI "
            << scene.structure.rods[0].section.EI1 << " N cm^2\n";
  return scene.design.problem() ? 1 : 0;
}
