#include "parts.hpp"

#include <algorithm>
#include <tencer/equilibrium/system.hpp>

namespace tencer::pipeline {
namespace {

using der::TwistModel;

std::string counted(int count, const std::string& thing) {
  return std::to_string(count) + ' ' + thing + (count == 1 ? "" : "s");
}

// "rod 0", "rods 0, 2"
std::string listed(const std::vector<int>& rods) {
  std::string text = rods.size() == 1 ? "rod " : "rods ";
  for (const int rod : rods) text += (rod == rods.front() ? "" : ", ") + std::to_string(rod);
  return text;
}

// The rods of which something holds.
template <class Holds>
std::vector<int> rods_where(const equilibrium::Structure& structure, const Holds& holds) {
  std::vector<int> rods;
  for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r)
    if (holds(structure.rods[r])) rods.push_back(r);
  return rods;
}

Part theta(const equilibrium::Structure& structure) {
  const auto uniform = rods_where(
      structure, [](const der::Rod& rod) { return der::twist_model(rod) == TwistModel::uniform; });
  const auto round = rods_where(
      structure, [](const der::Rod& rod) { return der::twist_model(rod) != TwistModel::per_edge; });
  const auto unequal =
      rods_where(structure, [](const der::Rod& rod) { return !rod.section.isotropic(); });
  const auto curved = rods_where(structure, [](const der::Rod& rod) {
    return rod.section.isotropic() && der::twist_model(rod) == TwistModel::per_edge;
  });
  int angles = 0;
  for (const int rod : round) angles += structure.rods[rod].edges();

  Part part{.name = "theta", .used = round.size() < structure.rods.size()};
  const auto add = [&](const std::string& text) {
    part.why += (part.why.empty() ? "" : "; ") + text;
  };
  if (!unequal.empty()) add("an angle an edge where the section has two axes, " + listed(unequal));
  if (!curved.empty()) add("an angle an edge where the rod is curved at rest, " + listed(curved));
  if (!round.empty())
    add((part.used ? listed(round) + " without: " : "every rod is ") +
        std::string("straight at rest and round, ") + counted(angles, "angle") + " fewer");
  if (!uniform.empty())
    add("one twisting moment where the closing angle is given, " + listed(uniform));
  return part;
}

Part z(const io::Scene& scene) {
  int vertices = 0;
  bool flat = true;
  for (const auto& rod : scene.rods) {
    vertices += rod.target.vertices();
    flat = flat && (rod.target.points.row(2).array() == scene.rods[0].target.points(2, 0)).all();
  }
  if (scene.planar)
    return {"z", false, "the scene is planar, " + counted(vertices, "unknown") + " fewer"};
  return {"z", true,
          flat ? "the target is flat, but planar = true is not said: rods may leave the plane"
               : "the target is not flat"};
}

Part registration(const io::Scene& scene, const Prepared& prepared) {
  if (prepared.target.align) return {"registration", true, "nothing holds the rods in space"};
  return {"registration", false,
          scene.pinned.empty() ? "cables to anchors hold the rods in space"
                               : "pinned vertices hold the rods in space"};
}

// Coordinates that pins take out of the unknowns.
int held_coordinates(const equilibrium::Structure& structure) {
  equilibrium::Structure unpinned = structure;
  unpinned.pins.clear();
  return equilibrium::System(unpinned).size() - equilibrium::System(structure).size();
}

Part loads(const equilibrium::Structure& structure) {
  if (structure.line_loads.empty() && structure.point_loads.empty())
    return {"loads", false, "neither gravity nor point loads"};
  if (structure.point_loads.empty()) return {"loads", true, "gravity"};
  return {"loads", true, structure.line_loads.empty() ? "point loads" : "gravity and point loads"};
}

Part external(const io::Scene& scene, const Prepared& prepared) {
  if (prepared.rules.external) return {"external cables", true, "there are anchors"};
  return {"external cables", false,
          scene.anchors.cols() == 0 ? "there are no anchors" : "external = false"};
}

Part symmetry(const io::Scene& scene, const Prepared& prepared) {
  if (prepared.symmetry)
    return {"symmetry", true,
            counted(prepared.symmetry->order(), "operation") + ", cables come and go in orbits"};
  if (scene.design.symmetry == "none" || scene.design.symmetry == "offer")
    return {"symmetry", false, "symmetry = \"" + scene.design.symmetry + "\""};
  return {"symmetry", false,
          scene.design.method == "force-balance" ? "rods, target and anchors have none"
                                                 : scene.design.method + " does not keep it"};
}

Part hand_over(const io::Scene& scene) {
  return {
      "hand-over", scene.design.hand_over,
      scene.design.hand_over ? "in the end cables to anchors take the place of pins" : "pins stay"};
}

Part optimizer(const io::Scene& scene) {
  if (scene.design.method == "force-balance")
    return {"outer optimizer", false, "force-balance fits with Gauss-Newton steps of its own"};
  return {"outer optimizer", true, scene.design.optimizer};
}

}  // namespace

std::vector<Part> parts_of(const io::Scene& scene, const Prepared& prepared) {
  std::vector<Part> parts{theta(prepared.structure), z(scene)};
  if (const int held = held_coordinates(prepared.structure); held > 0)
    parts.push_back({"pinned coordinates", false, counted(held, "unknown") + " fewer"});
  if (!scene.pinned.empty()) parts.push_back(hand_over(scene));
  parts.insert(parts.end(),
               {registration(scene, prepared), loads(prepared.structure), external(scene, prepared),
                symmetry(scene, prepared), optimizer(scene),
                Part{"sliding", true, "ends on rods slide along them in every scene"}});
  return parts;
}

}  // namespace tencer::pipeline
