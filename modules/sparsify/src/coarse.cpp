#include "coarse.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tencer/geometry/sampling.hpp>
#include <utility>

#include "walker.hpp"

namespace tencer::sparsify {
namespace {

geometry::ArcLength arc_of(const der::Rod& rod) { return {rod.rest_lengths, rod.closed}; }

double total_turning(const Eigen::Matrix3Xd& points, bool closed) {
  const Eigen::Index n = points.cols();
  double sum = 0;
  for (Eigen::Index i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i) {
    const Eigen::Vector3d before = points.col(i) - points.col((i + n - 1) % n);
    const Eigen::Vector3d after = points.col((i + 1) % n) - points.col(i);
    sum += std::atan2(before.cross(after).norm(), before.dot(after));
  }
  return sum;
}

bool may_be_coarse(const equilibrium::Structure& structure, int r) {
  const der::Rod& rod = structure.rods[r];
  return der::twist_model(rod) == der::TwistModel::none && rod.rest_curvature.size() == 0 &&
         std::ranges::all_of(structure.pins, [&](const equilibrium::Pin& pin) {
           const bool end = pin.vertex == 0 || pin.vertex == rod.vertices() - 1;
           return pin.rod != r || (!rod.closed && end);
         });
}

// Edges that are enough: each turns little. Multiples of twelve keep most symmetries.
int edges_for(const der::Rod& rod, const Eigen::Matrix3Xd& points) {
  constexpr int least = 48;
  constexpr double turn = 0.3;  // of a vertex, in radians
  const int needed = static_cast<int>(std::ceil(total_turning(points, rod.closed) / turn));
  return std::max(least, (needed + 11) / 12 * 12);
}

// The rod, its target points and weights with equal edges.
void coarsen(int edges, der::Rod& rod, Eigen::Matrix3Xd& points, Eigen::VectorXd& weights) {
  const geometry::ArcLength arc = arc_of(rod);
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

// The same rod at two resolutions: the edges of the one with fewer are equal on the other.
class Correspondence {
 public:
  Correspondence(const der::Rod& from, const der::Rod& to)
      : from_(arc_of(from)), to_(arc_of(to)), common_from_(from_), common_to_(to_) {
    const auto equal_edges = [](const der::Rod& rod, double length) {
      return geometry::ArcLength(Eigen::VectorXd::Constant(rod.edges(), length / rod.edges()),
                                 rod.closed);
    };
    if (from.edges() < to.edges()) common_from_ = equal_edges(from, to_.length());
    if (to.edges() < from.edges()) common_to_ = equal_edges(to, from_.length());
  }

  double place(double s) const { return moved(moved(s, from_, common_from_), common_to_, to_); }
  double factor() const { return to_.length() / from_.length(); }
  const geometry::ArcLength& to() const { return to_; }

  Eigen::Matrix3Xd positions(const Eigen::Matrix3Xd& x) const {
    return geometry::smooth_points(x, common_from_,
                                   common_to_.knots().head(to_.edges() + (to_.closed() ? 0 : 1)));
  }

 private:
  static double moved(double s, const geometry::ArcLength& from, const geometry::ArcLength& to) {
    const auto [edge, t] = from.locate(s);
    return to.knots()[edge] + t * to.edge_length(edge);
  }

  geometry::ArcLength from_, to_, common_from_, common_to_;
};

std::vector<Correspondence> correspondences(const std::vector<der::Rod>& from,
                                            const std::vector<der::Rod>& to) {
  std::vector<Correspondence> result;
  for (std::size_t r = 0; r < from.size(); ++r) result.emplace_back(from[r], to[r]);
  return result;
}

void carry(springs::End& end, const std::vector<Correspondence>& rods) {
  if (auto* on = std::get_if<springs::OnRod>(&end)) on->s = rods[on->rod].place(on->s);
}

}  // namespace

std::optional<Problem> coarsened(const equilibrium::Structure& structure,
                                 const sensitivity::Target& target, const Rules& rules) {
  constexpr double worthwhile = 0.75;  // of the vertices
  Problem problem{.structure = structure, .target = target, .rules = rules};
  auto& rods = problem.structure.rods;
  problem.structure.cables.clear();
  if (problem.target.weights.empty()) problem.target.weights.resize(rods.size());
  int before = 0;
  int after = 0;
  for (int r = 0; r < static_cast<int>(rods.size()); ++r) {
    before += rods[r].edges();
    const int edges = edges_for(rods[r], target.points[r]);
    if (edges < rods[r].edges() && may_be_coarse(structure, r)) {
      const int last = rods[r].vertices() - 1;
      coarsen(edges, rods[r], problem.target.points[r], problem.target.weights[r]);
      for (auto& pin : problem.structure.pins)
        if (pin.rod == r && pin.vertex == last) pin.vertex = rods[r].vertices() - 1;
    }
    after += rods[r].edges();
  }
  if (target.weights.empty()) problem.target.weights.clear();
  if (after > worthwhile * before) return std::nullopt;
  const auto same = correspondences(structure.rods, rods);
  for (auto& load : problem.structure.point_loads) load.s = same[load.rod].place(load.s);
  for (auto& arc : problem.rules.forbidden) {
    arc.from = same[arc.rod].place(arc.from);
    arc.to = same[arc.rod].place(arc.to);
  }
  auto found = candidates(problem.structure, problem.target.points, problem.rules);
  if (!found) return std::nullopt;
  problem.candidates = std::move(*found);
  return problem;
}

Network carried(const Network& network, const equilibrium::Structure& bare) {
  const auto& rods = network.structure.rods;
  const auto same = correspondences(rods, bare.rods);
  std::vector<Eigen::Matrix3Xd> positions;
  for (std::size_t r = 0; r < rods.size(); ++r)
    positions.push_back(same[r].positions(network.state[r].x));
  Network result{.structure = bare, .state = make_state(bare, positions)};
  for (std::size_t r = 0; r < rods.size(); ++r)
    if (rods[r].edges() == bare.rods[r].edges()) result.state[r] = network.state[r];
  const Eigen::VectorXd tensions = cable_tensions(network);
  std::vector<geometry::ArcLength> along;
  for (const auto& rod : same) along.push_back(rod.to());
  for (std::size_t c = 0; c < network.structure.cables.size(); ++c) {
    springs::Cable cable = network.structure.cables[c];
    carry(cable.a, same);
    carry(cable.b, same);
    const double length =
        equilibrium::span_of(springs::stencil(cable, along, bare.anchors), result.state).norm();
    cable.rest_length = taut * length;
    cable.stiffness = tensions[static_cast<Eigen::Index>(c)] / (length - cable.rest_length);
    result.structure.cables.push_back(cable);
  }
  return result;
}

symmetry::Group carried(const symmetry::Group& group, const std::vector<der::Rod>& from,
                        const std::vector<der::Rod>& to) {
  const auto same = correspondences(from, to);
  symmetry::Group result = group;
  for (std::size_t r = 0; r < to.size(); ++r) result.rods[r] = same[r].to();
  for (auto& operation : result.operations)
    for (std::size_t r = 0; r < to.size(); ++r) {
      auto& map = operation.rods[r];
      map.rate *= same[map.rod].factor() / same[r].factor();
      map.offset = same[map.rod].place(map.offset);
    }
  return result;
}

}  // namespace tencer::sparsify
