// Scene files, which may also name the curve file curve.obj: any bytes give a scene whose indices,
// ranges and sizes are valid, or an error that names a file and says something.
#include <tencer/io/scene.hpp>

#include "input_file.hpp"
#include "must.hpp"

using namespace tencer;
using fuzz::must;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  static const auto curve =
      folder.put("curve.obj",
                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 2\nv 1 0 3\nv 2 1 2\n"
                 "l 1 2 3 4 1\nl 5 6 7\n");
  // Long numbers only make large scenes, which take long.
  int digits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    digits = data[i] >= '0' && data[i] <= '9' ? digits + 1 : 0;
    if (digits > 4) return 0;
  }
  const auto path = folder.put("scene.toml", fuzz::text_of(data, size));
  const auto scene = io::read_scene(path);
  if (!scene) {
    must(scene.error().where.starts_with(path.parent_path().string()));
    must(!scene.error().message.empty());
    return 0;
  }
  const model::Structure& structure = scene->structure;
  const int rods = static_cast<int>(structure.rods.size());
  must(rods > 0);
  must(static_cast<int>(scene->directors.size()) == rods);
  must(static_cast<int>(scene->target.points.size()) == rods);
  must(static_cast<int>(scene->target.weights.size()) == rods);
  for (int r = 0; r < rods; ++r) {
    const der::Rod& rod = structure.rods[r];
    const geometry::Polyline target = target_curve(*scene, r);
    must(target.points.allFinite() && target.vertices() == rod.vertices());
    const Eigen::VectorXd lengths = geometry::edge_lengths(target);
    must(lengths.allFinite() && lengths.minCoeff() > 0);
    must(rod.rest_lengths == lengths);
    for (const double stiffness :
         {rod.section.EA, rod.section.EI1, rod.section.EI2, rod.section.GJ})
      must(std::isfinite(stiffness) && stiffness > 0);
    const Eigen::VectorXd& weights = scene->target.weights[r];
    must(weights.size() == rod.vertices());
    must(weights.allFinite() && weights.minCoeff() >= 0);
  }
  for (const model::Arc& arc : scene->rules.forbidden)
    must(arc.rod >= 0 && arc.rod < rods && std::isfinite(arc.from) && std::isfinite(arc.to));
  must(structure.anchors.allFinite());
  for (const model::Pin& pin : structure.pins)
    must(pin.rod >= 0 && pin.rod < rods && pin.vertex >= 0 &&
         pin.vertex < structure.rods[pin.rod].vertices());
  for (const model::PointLoad& load : structure.point_loads)
    must(load.rod >= 0 && load.rod < rods && std::isfinite(load.s) && load.force.allFinite());
  for (const model::LineLoad& load : structure.line_loads)
    must(load.rod >= 0 && load.rod < rods && load.force_per_length.allFinite());
  must(scene->design.max_error > 0);
  return 0;
}
