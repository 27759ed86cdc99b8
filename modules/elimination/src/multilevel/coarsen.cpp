#include "multilevel/coarsen.hpp"

#include <algorithm>
#include <cmath>
#include <tencer/geometry/corners.hpp>
#include <tencer/geometry/sampling.hpp>
#include <tencer/ground_structure/candidates.hpp>
#include <utility>

#include "multilevel/transfer.hpp"

namespace tencer::elimination {
namespace {

using ground_structure::Problem;

bool may_be_coarse(const model::Structure& structure, int r) {
  const der::Rod& rod = structure.rods[r];
  return der::twist_model(rod) == der::TwistModel::none && rod.rest_curvature.size() == 0 &&
         std::ranges::all_of(structure.pins, [&](const model::Pin& pin) {
           const bool end = pin.vertex == 0 || pin.vertex == rod.vertices() - 1;
           return pin.rod != r || (!rod.closed && end);
         });
}

// Edges that are enough: each turns little. Multiples of twelve keep most symmetries.
int edges_for(const der::Rod& rod, const Eigen::Matrix3Xd& points, const CoarseOptions& options) {
  const int needed =
      static_cast<int>(std::ceil(geometry::total_turning({points, rod.closed}) / options.max_turn));
  return std::max(options.min_edges, (needed + 11) / 12 * 12);
}

// The rod, its target points and weights with equal edges.
void coarsen(int edges, der::Rod& rod, Eigen::Matrix3Xd& points, Eigen::VectorXd& weights) {
  const geometry::ArcLength arc(rod.rest_lengths, rod.closed);
  const int vertices = rod.closed ? edges : edges + 1;
  const Eigen::VectorXd at =
      Eigen::VectorXd::LinSpaced(vertices, 0, arc.length() * (vertices - 1) / edges);
  const Eigen::Index n = points.cols();
  double drawn = 0;
  for (int j = 0; j < rod.edges(); ++j) drawn += (points.col((j + 1) % n) - points.col(j)).norm();
  if (weights.size() > 0) {
    Eigen::VectorXd fewer(vertices);
    for (int i = 0; i < vertices; ++i) {
      const auto [edge, t] = arc.locate(at[i]);
      fewer[i] = (1 - t) * weights[edge] + t * weights[(edge + 1) % n];
    }
    weights = std::move(fewer);
  }
  points = geometry::smooth_points(points, arc, at);
  rod.rest_lengths.resize(edges);
  for (int j = 0; j < edges; ++j)
    rod.rest_lengths[j] =
        (points.col((j + 1) % vertices) - points.col(j)).norm() * arc.length() / drawn;
}

// Coarsens the rods of `problem` that may be; whether that is worth while.
bool coarsen_rods(Problem& problem, const CoarseOptions& options) {
  model::Structure& structure = problem.structure;
  model::Target& target = problem.target;
  const bool weighted = !target.weights.empty();
  target.weights.resize(structure.rods.size());
  int before = 0;
  int after = 0;
  for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r) {
    der::Rod& rod = structure.rods[r];
    before += rod.edges();
    const int edges = edges_for(rod, target.points[r], options);
    if (edges < rod.edges() && may_be_coarse(structure, r)) {
      const int last = rod.vertices() - 1;
      coarsen(edges, rod, target.points[r], target.weights[r]);
      for (auto& pin : structure.pins)
        if (pin.rod == r && pin.vertex == last) pin.vertex = rod.vertices() - 1;
    }
    after += rod.edges();
  }
  if (!weighted) target.weights.clear();
  return after <= options.worthwhile * before;
}

}  // namespace

std::optional<Problem> coarsened(const Problem& problem, const CoarseOptions& options) {
  Problem coarse{.structure = problem.structure, .target = problem.target, .rules = problem.rules};
  if (!coarsen_rods(coarse, options)) return std::nullopt;
  const auto& rods = problem.structure.rods;
  const auto maps = resolution_maps(rods, coarse.structure.rods);
  for (auto& load : coarse.structure.point_loads) load.s = maps[load.rod].place(load.s);
  for (auto& arc : coarse.rules.forbidden) {
    arc.from = maps[arc.rod].place(arc.from);
    arc.to = maps[arc.rod].place(arc.to);
  }
  auto found = ground_structure::candidates(coarse.structure, coarse.target.points, coarse.rules);
  if (!found) return std::nullopt;
  coarse.candidates = std::move(*found);
  coarse.start = transferred(problem.bare(), coarse.structure).state;
  if (problem.symmetry)
    coarse.symmetry = transferred(*problem.symmetry, rods, coarse.structure.rods);
  return coarse;
}

}  // namespace tencer::elimination
