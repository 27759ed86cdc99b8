#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <tencer/core/names.hpp>
#include <tencer/symmetry/detect.hpp>

#include "detection/candidates.hpp"
#include "detection/match.hpp"
#include "detection/same_operation.hpp"
#include "detection/sampled.hpp"

namespace tencer::symmetry {
namespace {

double worst_misfit(const Sampled& sampled, const Group& group) {
  double worst = 0.0;
  for (const Operation& operation : group.operations)
    worst = std::max(worst, misfit(sampled, operation).relative);
  return worst;
}

// An axis or normal has no sign: the largest component is made positive.
Eigen::Vector3d upward(const Eigen::Vector3d& direction) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  return direction[largest] < 0.0 ? Eigen::Vector3d(-direction) : direction;
}

std::vector<model::SymmetryGenerator> elements(const Group& group, const Eigen::Vector3d& point) {
  std::vector<model::Rotation> axes;
  std::vector<model::SymmetryGenerator> planes;
  for (const Operation& operation : group.operations) {
    if (operation.matrix.determinant() < 0.0) {
      // A reflection is I - 2 n n^T.
      const Eigen::Matrix3d doubled = Eigen::Matrix3d::Identity() - operation.matrix;
      Eigen::Index column = 0;
      doubled.colwise().norm().maxCoeff(&column);
      const Eigen::Vector3d normal = doubled.col(column).normalized();
      if ((doubled - 2.0 * normal * normal.transpose()).norm() < 1e-6)
        planes.push_back(model::Reflection{.normal = upward(normal), .point = point});
      continue;
    }
    const Eigen::AngleAxisd turn(operation.matrix);
    if (turn.angle() < 1e-6) continue;
    const auto known = std::find_if(axes.begin(), axes.end(), [&](const model::Rotation& rotation) {
      return rotation.axis.cross(turn.axis()).norm() < 1e-6;
    });
    // Each of a k-fold axis' k - 1 rotations adds one.
    if (known != axes.end())
      ++known->fold;
    else
      axes.push_back({.fold = 2, .axis = upward(turn.axis()), .point = point});
  }
  std::stable_sort(
      axes.begin(), axes.end(),
      [](const model::Rotation& a, const model::Rotation& b) { return a.fold > b.fold; });
  std::vector<model::SymmetryGenerator> result(axes.begin(), axes.end());
  result.insert(result.end(), planes.begin(), planes.end());
  return result;
}

// The symmetry with its operations moved from the centred figure back to where the figure is.
Symmetry finish(const Sampled& sampled, Group group, double misfit) {
  Symmetry result{.group = {}, .elements = {}, .misfit = misfit};
  // All operations keep the mean of their translations.
  Eigen::Vector3d point = sampled.centre;
  for (const Operation& operation : group.operations)
    point += operation.translation / group.order();
  result.elements = elements(group, point);
  for (Operation& operation : group.operations)
    operation.translation += sampled.centre - operation.matrix * sampled.centre;
  result.group = std::move(group);
  return result;
}

std::string text(const Eigen::Vector3d& v) {
  std::ostringstream out;
  out << '(' << v.x() << ", " << v.y() << ", " << v.z() << ')';
  return out.str();
}

// The generator with a point, where it has none: that of all symmetries.
model::SymmetryGenerator placed(model::SymmetryGenerator generator, const Figure& figure) {
  std::visit(
      [&](auto& element) {
        if (!element.point) element.point = centroid(figure);
      },
      generator);
  return generator;
}

std::string text(const model::SymmetryGenerator& generator) {
  std::ostringstream out;
  if (const auto* rotation = std::get_if<model::Rotation>(&generator))
    out << "the " << rotation->fold << "-fold rotation about the axis " << text(rotation->axis)
        << " through " << text(*rotation->point);
  else
    out << "the reflection with normal " << text(std::get<model::Reflection>(generator).normal)
        << " in the plane through " << text(*std::get<model::Reflection>(generator).point);
  return out.str();
}

Operation map_of_space(const model::SymmetryGenerator& generator, const Eigen::Vector3d& centre) {
  Operation result;
  Eigen::Vector3d point;
  if (const auto* rotation = std::get_if<model::Rotation>(&generator)) {
    core::require(rotation->fold >= 2 && rotation->axis.allFinite() && rotation->axis.norm() > 0.0,
                  "symmetry: a rotation needs fold >= 2 and an axis that is not zero");
    result.matrix =
        Eigen::AngleAxisd(2.0 * std::numbers::pi / rotation->fold, rotation->axis.normalized())
            .toRotationMatrix();
    point = *rotation->point;
  } else {
    const auto& reflection = std::get<model::Reflection>(generator);
    core::require(reflection.normal.allFinite() && reflection.normal.norm() > 0.0,
                  "symmetry: a reflection needs a normal that is not zero");
    const Eigen::Vector3d normal = reflection.normal.normalized();
    result.matrix -= 2.0 * normal * normal.transpose();
    point = *reflection.point;
  }
  core::require(point.allFinite(), "symmetry: a point must be finite");
  result.translation = point - centre - result.matrix * (point - centre);
  return result;
}

// What is wrong with a generator that does not map the figure onto itself.
std::string complaint(const model::SymmetryGenerator& generator, const Misfit& worst,
                      std::size_t rods, double tolerance) {
  std::ostringstream out;
  out << text(generator) << " does not map the curves onto themselves: ";
  if (worst.rod >= 0)
    out << core::rod_in_words(worst.rod, rods);
  else
    out << core::anchor_name(worst.anchor);
  out << " misses what it should become by ";
  out.precision(3);
  out << 100.0 * worst.relative << " % of the bounding box's diagonal, where " << 100.0 * tolerance
      << " % is allowed";
  return out.str();
}

std::string objection(const Options& options, const Operation& operation) {
  return options.objection ? options.objection(operation) : std::string();
}

struct Found {
  Operation operation;
  double misfit;
};

// All operations that map the figure onto itself, each once, the best fit first.
std::vector<Found> single_operations(const Sampled& sampled, const Options& options) {
  const Candidates guesses = candidates(sampled, options.tolerance, options.continuous_fold);
  std::vector<Found> found;
  for (const Eigen::Matrix3d& matrix : guesses.matrices) {
    // Candidates are good to a few tolerances before they are polished.
    auto operation = match(sampled, matrix, Eigen::Vector3d::Zero(), 10.0 * options.tolerance);
    if (!operation) continue;
    polish(sampled, *operation, guesses.continuous ? Polish::shifts : Polish::shifts_and_map);
    const double miss = misfit(sampled, *operation).relative;
    if (miss > options.tolerance || !objection(options, *operation).empty()) continue;
    const auto known = std::find_if(found.begin(), found.end(), [&](const Found& other) {
      return same_operation(other.operation, *operation, sampled.figure.rods);
    });
    if (known == found.end())
      found.push_back({std::move(*operation), miss});
    else if (miss < known->misfit)
      *known = {std::move(*operation), miss};
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.misfit < b.misfit; });
  return found;
}

// Operations just within the tolerance may have products that are not: the best fit first, the
// group grows as long as all of it fits. `worst`: its largest misfit.
Group largest_group(const Sampled& sampled, const std::vector<Found>& found, const Options& options,
                    double& worst) {
  const Figure& figure = sampled.figure;
  const int anchors = static_cast<int>(figure.anchors.cols());
  const auto make_group = [&](const std::vector<Operation>& generators) {
    return closure(generators, figure.rods, anchors, options.max_order);
  };
  std::vector<Operation> generators;
  Group group = make_group(generators).value();
  for (const Found& candidate : found) {
    const bool known = std::any_of(
        group.operations.begin(), group.operations.end(), [&](const Operation& operation) {
          return same_operation(operation, candidate.operation, figure.rods);
        });
    if (known) continue;
    generators.push_back(candidate.operation);
    auto larger = make_group(generators);
    const double larger_worst = larger ? worst_misfit(sampled, *larger) : 0.0;
    if (!larger || larger_worst > options.tolerance) {
      generators.pop_back();
      continue;
    }
    group = std::move(*larger);
    worst = larger_worst;
  }
  return group;
}

}  // namespace

void Options::validate() const {
  core::require(tolerance > 0.0 && tolerance < 0.05,
                "symmetry::Options::tolerance must be between 0 and 0.05");
  core::require(max_order >= 1, "symmetry::Options::max_order must be positive");
  core::require(continuous_fold >= 1, "symmetry::Options::continuous_fold must be positive");
}

Symmetry detect(const Figure& figure, const Options& options) {
  validate(figure);
  options.validate();
  const Sampled sampled = sample(figure);
  double worst = 0.0;
  Group group = largest_group(sampled, single_operations(sampled, options), options, worst);
  return finish(sampled, std::move(group), worst);
}

core::Expected<Symmetry> verify(const Figure& figure,
                                std::span<const model::SymmetryGenerator> generators,
                                const Options& options) {
  validate(figure);
  options.validate();
  const Sampled sampled = sample(figure);
  std::vector<Operation> operations;
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const std::string where = "symmetry[" + std::to_string(i) + "]";
    const model::SymmetryGenerator generator = placed(generators[i], figure);
    const Operation wanted = map_of_space(generator, sampled.centre);
    auto operation = match(sampled, wanted.matrix, wanted.translation, 0.0);
    if (!operation)
      return core::Error{where, text(generator) + " brings two rods or anchors to the same one"};
    polish(sampled, *operation, Polish::shifts);
    const Misfit worst = misfit(sampled, *operation);
    if (worst.relative > options.tolerance)
      return core::Error{where,
                         complaint(generator, worst, figure.curves.size(), options.tolerance)};
    if (const std::string broken = objection(options, *operation); !broken.empty())
      return core::Error{where, text(generator) + " is not a symmetry of the scene: it " + broken};
    operations.push_back(std::move(*operation));
  }
  auto group =
      closure(operations, figure.rods, static_cast<int>(figure.anchors.cols()), options.max_order);
  if (!group) return group.error();
  const double worst = worst_misfit(sampled, *group);
  return finish(sampled, std::move(*group), worst);
}

}  // namespace tencer::symmetry
