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
  const int rods = static_cast<int>(scene->rods.size());
  must(rods > 0);
  for (const io::SceneRod& rod : scene->rods) {
    must(rod.target.points.allFinite());
    const Eigen::VectorXd lengths = geometry::edge_lengths(rod.target);
    must(lengths.allFinite() && lengths.minCoeff() > 0);
    const io::Section& section = rod.section;
    must(std::isfinite(section.EA) && section.EA > 0 && std::isfinite(section.GJ) &&
         section.GJ > 0);
    must(section.EI.allFinite() && section.EI.minCoeff() > 0);
    must(rod.weights.size() == rod.target.vertices());
    must(rod.weights.allFinite() && rod.weights.minCoeff() >= 0);
    for (const io::Arc& arc : rod.forbidden_arcs)
      must(std::isfinite(arc.from) && std::isfinite(arc.to));
    for (const int vertex : rod.forbidden_vertices)
      must(vertex >= 0 && vertex < rod.target.vertices());
  }
  must(scene->anchors.allFinite());
  for (const io::Pin& pin : scene->pinned)
    must(pin.rod >= 0 && pin.rod < rods && pin.vertex >= 0 &&
         pin.vertex < scene->rods[pin.rod].target.vertices());
  for (const io::PointLoad& load : scene->point_loads)
    must(load.rod >= 0 && load.rod < rods && std::isfinite(load.s) && load.force.allFinite());
  for (const io::LineLoad& load : scene->line_loads)
    must(load.rod >= 0 && load.rod < rods && load.force_per_length.allFinite());
  must(scene->design.max_error > 0);
  return 0;
}
