#include <algorithm>
#include <tencer/core/names.hpp>
#include <tencer/core/words.hpp>
#include <tencer/equilibrium/system.hpp>
#include <tencer/pipeline/omissions.hpp>

namespace tencer::pipeline {
namespace {

using core::counted;
using der::TwistModel;

// The rods of which something holds.
template <class Holds>
std::vector<int> rods_where(const model::Structure& structure, const Holds& holds) {
  std::vector<int> rods;
  for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r)
    if (holds(structure.rods[r])) rods.push_back(r);
  return rods;
}

Feature theta(const model::Structure& structure) {
  const auto uniform = rods_where(
      structure, [](const der::Rod& rod) { return der::twist_model(rod) == TwistModel::uniform; });
  const auto round = rods_where(
      structure, [](const der::Rod& rod) { return der::twist_model(rod) != TwistModel::per_edge; });
  const auto unequal =
      rods_where(structure, [](const der::Rod& rod) { return !rod.section.isotropic(); });
  const auto curved = rods_where(structure, [](const der::Rod& rod) {
    return rod.section.isotropic() && der::twist_model(rod) == TwistModel::per_edge;
  });
  const auto named = [&](const std::vector<int>& rods) {
    return core::rods_in_words(rods, structure.rods.size());
  };
  int angles = 0;
  for (const int rod : round) angles += structure.rods[rod].edges();

  Feature feature{.name = "theta", .used = round.size() < structure.rods.size()};
  const auto add = [&](const std::string& text) {
    feature.why += (feature.why.empty() ? "" : "; ") + text;
  };
  if (!unequal.empty()) add("an angle an edge where the section has two axes: " + named(unequal));
  if (!curved.empty()) add("an angle an edge where the rod is curved at rest: " + named(curved));
  if (!round.empty())
    add((feature.used ? named(round) + " without: " : "every rod is ") +
        std::string("straight at rest and round, ") + counted(angles, "angle") + " fewer");
  if (!uniform.empty())
    add("one twisting moment where the closing angle is given: " + named(uniform));
  return feature;
}

Feature z(const model::Scene& scene) {
  int vertices = 0;
  bool flat = true;
  for (const auto& points : scene.target.points) {
    vertices += static_cast<int>(points.cols());
    flat = flat && (points.row(2).array() == scene.target.points[0](2, 0)).all();
  }
  if (scene.structure.planar)
    return {"z", false, "the scene is planar, " + counted(vertices, "unknown") + " fewer"};
  return {"z", true,
          flat ? "the target is flat, but planar = true is not said: rods may leave the plane"
               : "the target is not flat"};
}

Feature registration(const model::Scene& scene, const Prepared& prepared) {
  if (prepared.problem.target.align)
    return {"registration", true, "nothing holds the rods in space"};
  return {"registration", false,
          scene.structure.pins.empty() ? "cables to anchors hold the rods in space"
                                       : "pinned vertices hold the rods in space"};
}

Feature view(const model::Scene& scene) {
  const auto& views = scene.target.views;
  if (views.empty()) return {"view", false, "distances count in space, from whatever side"};
  return {"view", true, "distances count as " + model::seen_in_words(views)};
}

// Coordinates that pins take out of the unknowns.
int held_coordinates(const model::Structure& structure) {
  model::Structure unpinned = structure;
  unpinned.pins.clear();
  return equilibrium::System(unpinned).size() - equilibrium::System(structure).size();
}

Feature loads(const model::Structure& structure) {
  if (structure.line_loads.empty() && structure.point_loads.empty())
    return {"loads", false, "neither gravity nor point loads"};
  if (structure.point_loads.empty()) return {"loads", true, "gravity"};
  return {"loads", true, structure.line_loads.empty() ? "point loads" : "gravity and point loads"};
}

Feature external(const model::Scene& scene, const Prepared& prepared) {
  if (prepared.problem.rules.external) return {"external cables", true, "there are anchors"};
  return {"external cables", false,
          scene.structure.anchors.cols() == 0 ? "there are no anchors" : "external = false"};
}

Feature symmetry(const model::Scene& scene, const Prepared& prepared) {
  using model::SymmetryUse;
  const model::DesignSettings& settings = scene.design;
  if (prepared.problem.symmetry)
    return {"symmetry", true,
            counted(prepared.problem.symmetry->order(), "operation") +
                ", cables come and go in orbits"};
  if (settings.symmetry == SymmetryUse::none || settings.symmetry == SymmetryUse::suggest)
    return {"symmetry", false,
            "symmetry = \"" + std::string(model::name_of(settings.symmetry)) + "\""};
  return {"symmetry", false,
          settings.method == model::Method::force_balance
              ? "rods, target and anchors have none"
              : std::string(model::name_of(settings.method)) + " does not keep it"};
}

Feature hand_over(const model::Scene& scene) {
  return {
      "hand-over", scene.design.hand_over,
      scene.design.hand_over ? "in the end cables to anchors take the place of pins" : "pins stay"};
}

Feature optimizer(const model::Scene& scene) {
  if (scene.design.method == model::Method::force_balance &&
      scene.design.optimizer == model::Optimizer::gauss_newton)
    return {"outer optimizer", false, "force-balance fits with Gauss-Newton steps of its own"};
  return {"outer optimizer", true, std::string(model::name_of(scene.design.optimizer))};
}

}  // namespace

std::vector<Feature> features_of(const model::Scene& scene, const Prepared& prepared) {
  std::vector<Feature> features{theta(prepared.problem.structure), z(scene)};
  if (const int held = held_coordinates(prepared.problem.structure); held > 0)
    features.push_back({"pinned coordinates", false, counted(held, "unknown") + " fewer"});
  if (!scene.structure.pins.empty()) features.push_back(hand_over(scene));
  features.insert(features.end(),
                  {registration(scene, prepared), view(scene), loads(prepared.problem.structure),
                   external(scene, prepared), symmetry(scene, prepared), optimizer(scene),
                   Feature{"sliding", true, "ends on rods slide along them in every scene"}});
  return features;
}

}  // namespace tencer::pipeline
