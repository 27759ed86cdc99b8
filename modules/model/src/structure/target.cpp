#include <algorithm>
#include <stdexcept>
#include <tencer/core/error.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/model/target.hpp>
#include <utility>

namespace tencer::model {

Target make_target(const Structure& structure, std::vector<Eigen::Matrix3Xd> points,
                   std::vector<Eigen::VectorXd> weights) {
  const bool held = !structure.pins.empty() || std::ranges::any_of(structure.cables, is_external);
  return {.points = std::move(points),
          .weights = std::move(weights),
          .align = !held,
          .planar = structure.planar};
}

void validate(const Target& target, const Structure& structure) {
  const auto& rods = structure.rods;
  core::require(target.points.size() == rods.size(), "target: needs the points of every rod");
  core::require(target.weights.empty() || target.weights.size() == rods.size(),
                "target: needs the weights of every rod or of none");
  double sum = 0;
  for (std::size_t r = 0; r < rods.size(); ++r) {
    core::require(target.points[r].cols() == rods[r].vertices() && target.points[r].allFinite(),
                  "target: needs a finite point for every vertex of a rod");
    const Eigen::VectorXd weights = weights_of(target, r);
    core::require(
        weights.size() == rods[r].vertices() && weights.allFinite() && weights.minCoeff() >= 0,
        "target: needs a finite weight >= 0 for every vertex of a rod");
    sum += weights.sum();
  }
  core::require(sum > 0, "target: the weights must not all be zero");
  core::require(target.views.empty() || !target.planar,
                "target: one in the plane z = const is not seen from a side");
  if (const auto problem = view_problem(target.views))
    throw std::invalid_argument("target: " + *problem);
}

Eigen::VectorXd weights_of(const Target& target, std::size_t rod) {
  if (target.weights.empty()) return Eigen::VectorXd::Ones(target.points[rod].cols());
  return target.weights[rod];
}

double diagonal(const Target& target) {
  std::vector<geometry::Polyline> curves;
  for (const auto& points : target.points) curves.push_back({.points = points});
  return geometry::bounding_box_diagonal(curves);
}

}  // namespace tencer::model
