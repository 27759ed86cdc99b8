#include <cmath>
#include <sstream>
#include <tencer/ground_structure/problem_symmetry.hpp>
#include <tencer/pipeline/symmetry.hpp>
#include <tencer/symmetry/detect.hpp>
#include <utility>
#include <vector>

namespace tencer::pipeline {
namespace {

using ground_structure::detected;
using ground_structure::Problem;
using symmetry::Operation;

std::vector<model::SymmetryGenerator> scaled(std::vector<model::SymmetryGenerator> generators,
                                             const model::Scaling& scaling) {
  for (auto& generator : generators)
    std::visit(
        [&](auto& element) {
          if (element.point) element.point = scaling.scaled(*element.point);
        },
        generator);
  return generators;
}

// The generators of a scene checked against its figure, in the scene's own coordinates so that
// errors speak of these.
core::Error in_scene_units(const model::Scene& scene, const Problem& problem,
                           const symmetry::Figure& figure, const model::Scaling& scaling,
                           const core::Error& error) {
  symmetry::Figure unscaled = figure;
  const double length = scaling.scale.length;
  unscaled.rods.clear();
  for (auto& curve : unscaled.curves) curve.points = scaling.unscaled(curve.points);
  for (const auto& rod : problem.structure.rods)
    unscaled.rods.emplace_back(length * rod.rest_lengths, rod.closed);
  unscaled.anchors = scaling.unscaled(unscaled.anchors);
  const auto again =
      symmetry::verify(unscaled, scene.generators, {.objection = [&](const Operation& operation) {
                         Operation scaled = operation;
                         for (auto& map : scaled.rods) map.offset /= length;
                         return ground_structure::broken_by(scaled, problem, figure);
                       }});
  return again ? error : again.error();
}

core::Expected<symmetry::Symmetry> given(const model::Scene& scene, const Problem& problem,
                                         const model::Scaling& scaling) {
  const symmetry::Figure figure = ground_structure::figure_of(problem);
  auto found = symmetry::verify(figure, scaled(scene.generators, scaling),
                                {.objection = [&](const Operation& operation) {
                                  return ground_structure::broken_by(operation, problem, figure);
                                }});
  if (found) return found;
  const core::Error error = in_scene_units(scene, problem, figure, scaling, found.error());
  return core::Error{scene.source, "design." + error.where + ": " + error.message};
}

const double exact = symmetry::Options{}.tolerance;

std::string direction_text(const Eigen::Vector3d& direction) {
  std::ostringstream text;
  text.precision(3);
  const auto rounded = [&](double x) { return std::abs(x) < 5e-4 ? 0.0 : x; };
  text << '(' << rounded(direction.x()) << ", " << rounded(direction.y()) << ", "
       << rounded(direction.z()) << ')';
  return text.str();
}

}  // namespace

core::Expected<std::optional<symmetry::Group>> symmetry_of(const model::Scene& scene,
                                                           const Problem& problem,
                                                           const model::Scaling& scaling) {
  std::optional<symmetry::Group> group;
  if (scene.design.symmetry == model::SymmetryUse::given) {
    auto found = given(scene, problem, scaling);
    if (!found) return found.error();
    group = std::move(found->group);
  } else if (scene.design.symmetry == model::SymmetryUse::detect) {
    group = detected(problem, exact).group;
  }
  if (group && group->order() == 1) group.reset();
  return group;
}

std::string symmetry_in_words(const Problem& problem) {
  const symmetry::Symmetry found = detected(problem, exact);
  if (found.group.order() == 1) return {};
  std::vector<std::string> parts;
  int axes = 0;
  int planes = 0;
  std::string first_plane;
  for (const auto& element : found.elements) {
    if (const auto* rotation = std::get_if<model::Rotation>(&element)) {
      // The highest fold comes first.
      if (++axes == 1)
        parts.push_back("a " + std::to_string(rotation->fold) + "-fold rotation about " +
                        direction_text(rotation->axis));
    } else if (++planes == 1) {
      first_plane = direction_text(std::get<model::Reflection>(element).normal);
    }
  }
  if (axes > 1) parts.push_back(std::to_string(axes - 1) + " further axes of rotation");
  if (planes == 1) parts.push_back("a mirror plane across " + first_plane);
  if (planes > 1) parts.push_back(std::to_string(planes) + " mirror planes");
  if (parts.empty())
    return std::to_string(found.group.order()) + " operations that map it onto itself";
  std::string text = parts[0];
  for (std::size_t i = 1; i < parts.size(); ++i)
    text += (i + 1 < parts.size() ? ", " : " and ") + parts[i];
  return text;
}

}  // namespace tencer::pipeline
