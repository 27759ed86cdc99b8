#include "multilevel/coarsen.hpp"

#include <algorithm>
#include <cmath>
#include <tencer/geometry/corners.hpp>
#include <tencer/geometry/polyline.hpp>
#include <tencer/geometry/sampling.hpp>
#include <tencer/ground_structure/candidates.hpp>
#include <utility>

#include "multilevel/transfer.hpp"

namespace tencer::elimination {

bool alike_all_along(const model::Structure& structure, int r) {
  const der::Rod& rod = structure.rods[r];
  return der::twist_model(rod) == der::TwistModel::none && rod.rest_curvature.size() == 0 &&
         std::ranges::all_of(structure.pins, [&](const model::Pin& pin) {
           const bool end = pin.vertex == 0 || pin.vertex == rod.vertices() - 1;
           return pin.rod != r || (!rod.closed && end);
         });
}

double rounded(double x) {
  if (!std::isfinite(x)) return x;
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  constexpr int bits = 24;
  return std::ldexp(std::round(std::ldexp(mantissa, bits)), exponent - bits);
}

Workmanship rounded(Workmanship workmanship) {
  for (double* number : {&workmanship.length_error, &workmanship.attachment_error,
                         &workmanship.max_deviation, &workmanship.min_tension})
    *number = rounded(*number);
  return workmanship;
}

namespace {

using ground_structure::Problem;

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
    if (edges < rod.edges() && alike_all_along(structure, r)) {
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

bool can_be_rounded(const Problem& problem) {
  if (problem.symmetry) return false;  // rounding would break it
  for (int r = 0; r < static_cast<int>(problem.structure.rods.size()); ++r)
    if (!alike_all_along(problem.structure, r)) return false;
  return true;
}

void round_off(double& number) { number = rounded(number); }

void round_off(der::Section& section) {
  for (double* stiffness : {&section.EA, &section.EI1, &section.EI2, &section.GJ})
    round_off(*stiffness);
  if (auto* circle = std::get_if<der::Circle>(&section.shape)) round_off(circle->radius);
  if (auto* tube = std::get_if<der::Tube>(&section.shape)) {
    round_off(tube->outer_radius);
    round_off(tube->inner_radius);
  }
  if (auto* rectangle = std::get_if<der::Rectangle>(&section.shape)) {
    round_off(rectangle->width);
    round_off(rectangle->height);
  }
}

// The points to so small a part of an edge that the rod turns far less by it than by its shape;
// edges keep their stretch.
void round_off(der::Rod& rod, Eigen::Matrix3Xd& points) {
  constexpr double part = 3e-4;
  const auto drawn = [&] { return geometry::edge_lengths({points, rod.closed}); };
  const double stretch = rounded(rod.length() / drawn().sum());
  const double grid = std::exp2(std::floor(std::log2(part * rod.rest_lengths.mean())));
  points = (points.array() / grid).round() * grid;
  rod.rest_lengths = stretch * drawn();
  round_off(rod.section);
}

void round_off(model::Rules& rules) {
  round_off(rules.max_cable_length);
  if (rules.gaps && rules.gaps->clearance) round_off(*rules.gaps->clearance);
  if (rules.gaps && rules.gaps->mark_distance) round_off(*rules.gaps->mark_distance);
}

void round_off(Problem& problem) {
  model::Structure& structure = problem.structure;
  for (std::size_t r = 0; r < structure.rods.size(); ++r)
    round_off(structure.rods[r], problem.target.points[r]);
  round_off(problem.rules);
  for (model::View& view : problem.target.views) {
    constexpr double grid = 1.0 / (1 << 24);
    view.direction = (view.direction.normalized().array() / grid).round() * grid;
  }
  const auto all = [](auto& numbers) {
    numbers = numbers.unaryExpr([](double x) { return rounded(x); }).eval();
  };
  all(structure.anchors);
  for (auto& load : structure.point_loads) all(load.force);
  for (auto& load : structure.line_loads) all(load.force_per_length);
}

}  // namespace

std::optional<Problem> coarsened(const Problem& problem, const CoarseOptions& options) {
  Problem coarse{.structure = problem.structure, .target = problem.target, .rules = problem.rules};
  const bool alike = can_be_rounded(problem);
  if (!coarsen_rods(coarse, options)) {
    if (!alike) return std::nullopt;
    coarse.structure = problem.structure;
    coarse.target = problem.target;
  }
  if (alike) round_off(coarse);
  const auto& rods = problem.structure.rods;
  const auto maps = resolution_maps(rods, coarse.structure.rods);
  for (auto& load : coarse.structure.point_loads) load.s = maps[load.rod].place(load.s);
  for (auto& arc : coarse.rules.forbidden) {
    arc.from = maps[arc.rod].place(arc.from);
    arc.to = maps[arc.rod].place(arc.to);
  }
  for (auto& cable : coarse.rules.unwanted) transfer(cable, maps);
  auto found = ground_structure::candidates(coarse.structure, coarse.target.points, coarse.rules);
  if (!found) return std::nullopt;
  coarse.candidates = std::move(*found);
  coarse.start = alike ? make_state(coarse.structure, coarse.target.points)
                       : transferred(problem.bare(), coarse.structure).state;
  if (problem.symmetry)
    coarse.symmetry = transferred(*problem.symmetry, rods, coarse.structure.rods);
  return coarse;
}

}  // namespace tencer::elimination
