#include <tencer/model/redesign.hpp>

namespace tencer::model {

Scene scene_of(const Design& design, const Material& standard) {
  Scene scene{.name = design.name,
              .source = design.name,
              .length_unit = design.length_unit,
              .force_unit = design.force_unit};
  const Structure& given = design.structure;
  for (std::size_t r = 0; r < given.rods.size(); ++r) {
    add_rod(scene, {design.target[r], given.rods[r].closed},
            given.materials.empty() ? standard : given.materials[r]);
    der::Rod& rod = scene.structure.rods.back();
    const Eigen::VectorXd lengths = rod.rest_lengths;
    rod = given.rods[r];
    rod.rest_lengths = lengths;
    if (r < design.target_directors.size() && design.target_directors[r].cols() > 0)
      scene.directors.back() = design.target_directors[r].col(0);
  }
  scene.structure.anchors = given.anchors;
  scene.structure.pins = given.pins;
  scene.structure.point_loads = given.point_loads;
  scene.structure.line_loads = given.line_loads;
  scene.structure.planar = scene.target.planar = given.planar;
  scene.target.views = design.views;
  return scene;
}

}  // namespace tencer::model
