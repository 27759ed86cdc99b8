// A scene: the task of a design as plain data, in the user's units.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <tencer/geometry/polyline.hpp>
#include <tencer/model/rules.hpp>
#include <tencer/model/settings.hpp>
#include <tencer/model/symmetry.hpp>
#include <tencer/model/target.hpp>
#include <vector>

namespace tencer::model {

struct Scene {
  std::string name{};
  std::string source{};  // where it came from; errors begin with it
  std::string length_unit = "cm";
  std::string force_unit = "N";
  // The rods, as long as the edges of their targets and bent at rest as they are, without cables.
  Structure structure{};
  Target target{};  // whether it is aligned is settled when the scene is prepared
  // Per rod, where the section's first axis points at the start of the target, to begin with; not
  // set: however the rod likes best.
  std::vector<std::optional<Eigen::Vector3d>> directors{};
  Rules rules{};
  std::vector<SymmetryGenerator> generators{};  // for SymmetryUse::given
  DesignSettings design{};
};

// The curve that a rod's target is.
geometry::Polyline target_curve(const Scene& scene, std::size_t rod);
std::vector<geometry::Polyline> target_curves(const Scene& scene);

// Adds a rod with `curve` as its target: straight at rest, weights of 1, no director. Its section
// is for the caller to set.
void add_rod(Scene& scene, const geometry::Polyline& curve);

// Two vertices of the targets that coincide, in words, so that a cable between them would have no
// length; not set when there are none.
std::optional<std::string> touching_vertices(const Scene& scene);

// The radius of all rods of a scene that says nothing of it: 1/1000 of the longest.
double default_radius(const std::vector<geometry::Polyline>& curves);

// Young's modulus of glass fibre, 40 GPa (paper table 1), in force_unit / length_unit^2. Units: mm,
// cm, m; mN, N, kN. Throws std::invalid_argument for others.
double glass_fibre_modulus(const std::string& length_unit, const std::string& force_unit);

// The scene of bare curves with every default: round glass fibre, a thousandth of the longest rod
// in radius. Lengths are in length_unit.
Scene scene_of(const std::vector<geometry::Polyline>& curves, std::string name = "curves",
               std::string length_unit = "cm", std::string force_unit = "N");

}  // namespace tencer::model
