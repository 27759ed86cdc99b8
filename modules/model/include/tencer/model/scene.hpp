// A scene: the task of a design as plain data, in the user's units.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <tencer/geometry/polyline.hpp>
#include <tencer/model/build.hpp>
#include <tencer/model/edit.hpp>
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
  std::vector<std::string> notes{};  // what was made of the input that its author may want to know
  std::vector<SymmetryGenerator> generators{};  // for SymmetryUse::given
  DesignSettings design{};
  BuildSettings build{};
  std::optional<Edit> edit{};  // of another design; not set: designed anew
};

// The curve that a rod's target is.
geometry::Polyline target_curve(const Scene& scene, std::size_t rod);
std::vector<geometry::Polyline> target_curves(const Scene& scene);

// Adds a rod with `curve` as its target: straight at rest, weights of 1, no director. Its section
// is for the caller to set.
void add_rod(Scene& scene, const geometry::Polyline& curve,
             const Material& material = glass_fibre());

// Where the targets cross each other or themselves, in words, with or without a vertex there; not
// set when they do not. Time grows with the square of the number of edges.
std::optional<std::string> crossing(const Scene& scene);

// The radius of all round rods of a scene that says nothing of it, so that they can be built: the
// largest of two digits with which no bend of a curve, corners apart, strains the material by more
// than 0.8 of what it holds for long, and at most 1/1000 of the longest curve. Units of the curves.
double chosen_radius(const std::vector<geometry::Polyline>& curves, const Material& material);

// The scene of bare curves with every default: round rods of one stock, of the radius above.
// Lengths are in length_unit; units as in units.hpp, std::invalid_argument for others.
Scene scene_of(const std::vector<geometry::Polyline>& curves, std::string name = "curves",
               std::string length_unit = "cm", std::string force_unit = "N",
               const Material& material = glass_fibre());

// What is to be built, in one line: "1 closed rod, 197.8 cm, circle r 0.95 mm, glass fibre, 12 g;
// fits in 38 x 35 x 14 cm". Sizes are those of the targets; what is not known is left out.
std::string in_one_line(const Scene& scene);

}  // namespace tencer::model
