#include "multilevel/canonical.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tencer/geometry/arc_length.hpp>
#include <tuple>
#include <utility>

#include "multilevel/coarsen.hpp"

namespace tencer::elimination {
namespace {

using ground_structure::Problem;

// The number that vertex i of a rod counted anew had, and the edge that follows it.
int vertex_before(const Way& way, int i, int vertices) {
  return (way.reversed ? way.start - i + vertices : way.start + i) % vertices;
}
int edge_before(const Way& way, int j, const der::Rod& rod) {
  const int n = rod.closed ? rod.edges() : rod.vertices();
  return (way.reversed ? way.start - j - 1 + n : way.start + j) % n;
}

Eigen::Matrix3Xd counted_anew(const Eigen::Matrix3Xd& columns, const Way& way) {
  Eigen::Matrix3Xd result(3, columns.cols());
  const auto n = static_cast<int>(columns.cols());
  for (int i = 0; i < n; ++i) result.col(i) = columns.col(vertex_before(way, i, n));
  return result;
}

// Where the shape is widest: far from the middle, its neighbours far apart. Mirror images of a
// curve and its reverse have their widest places in common.
int widest(const Eigen::Matrix3Xd& x) {
  const auto n = static_cast<int>(x.cols());
  const int apart = std::max(1, n / 8);
  int best = 0;
  double most = -1;
  for (int v = 0; v < n; ++v) {
    const double width =
        x.col(v).norm() + 0.5 * (x.col((v + apart) % n) - x.col((v - apart + n) % n)).norm();
    if (width > most) std::tie(best, most) = std::pair{v, width};
  }
  return best;
}

// How the half of the curve that follows vertex 0 lies against the half before it: a number that
// changes its sign when the curve is counted the other way. The volumes tell mirror images apart.
double lopsided(const Eigen::Matrix3Xd& x, bool closed) {
  const auto n = static_cast<int>(x.cols());
  const int half = (n - 1) / 2;
  const int last = closed ? 0 : n - 1;
  const auto before = [&](int j) { return closed ? n - j : n - 1 - j; };
  const auto side = [&](int end, int a, int b) {
    const Eigen::Vector3d from = x.col(end);
    const double volume = from.dot(x.col(a).cross(x.col(b)));
    return x.col(a).norm() + (x.col(a) - from).norm() +
           volume / std::max(x.colwise().squaredNorm().maxCoeff(), 1e-300);
  };
  double sum = 0;
  for (int j = 1; j <= half; ++j) {
    const int further = half - j / 2;
    sum += (side(0, j, further) - side(last, before(j), before(further))) / j;
  }
  return sum;
}

Way way_of(const Eigen::Matrix3Xd& x, bool closed) {
  Way way{.start = closed ? widest(x) : 0};
  if (lopsided(counted_anew(x, way), closed) >= 0) return way;
  return {.start = closed ? way.start : static_cast<int>(x.cols()) - 1, .reversed = true};
}

// The rotation that brings the first rod's first vertex onto the x axis and what is then furthest
// from that axis into the plane of x and y. In the plane only about z.
Eigen::Matrix3d turn_of(const std::vector<Eigen::Matrix3Xd>& points, bool planar) {
  Eigen::Vector3d x = points.front().col(0);
  if (planar) x.z() = 0;
  double size = 0;
  for (const auto& rod : points) size = std::max(size, rod.colwise().norm().maxCoeff());
  if (!(x.norm() > 1e-6 * size)) return Eigen::Matrix3d::Identity();
  x.normalize();
  Eigen::Vector3d y = Eigen::Vector3d::Zero();
  for (const auto& rod : points)
    for (Eigen::Index i = 0; i < rod.cols(); ++i) {
      const Eigen::Vector3d across = rod.col(i) - x * x.dot(rod.col(i));
      if (across.norm() > (1 + 1e-6) * y.norm()) y = across;
    }
  if (planar) y = Eigen::Vector3d::UnitZ().cross(x);
  if (!(y.norm() > 1e-6 * size)) return Eigen::Matrix3d::Identity();
  Eigen::Matrix3d turn;
  turn.row(0) = x;
  turn.row(1) = y.normalized();
  turn.row(2) = x.cross(y.normalized());
  return turn;
}

// Arc lengths of a rod counted anew.
class Places {
 public:
  Places(const der::Rod& rod, const Way& way)
      : arc_(rod.rest_lengths, rod.closed), start_(arc_.knots()[way.start]), way_(way) {}
  double anew(double s) const { return arc_.wrap(way_.reversed ? start_ - s : s - start_); }
  double before(double s) const { return arc_.wrap(way_.reversed ? start_ - s : s + start_); }

 private:
  geometry::ArcLength arc_;
  double start_;
  Way way_;
};

std::vector<Places> places_of(const std::vector<der::Rod>& rods, const std::vector<Way>& ways) {
  std::vector<Places> result;
  for (std::size_t r = 0; r < rods.size(); ++r) result.emplace_back(rods[r], ways[r]);
  return result;
}

void count_anew(springs::End& end, const std::vector<Places>& places) {
  if (auto* on = std::get_if<springs::OnRod>(&end)) on->s = places[on->rod].anew(on->s);
}

// The ends of a cable and the cables in the order of their places, whatever it was.
void count_anew(std::vector<springs::Cable>& candidates, const std::vector<Places>& places) {
  const auto key = [](const springs::End& end) {
    const auto* on = std::get_if<springs::OnRod>(&end);
    return on ? std::tuple(0, on->rod, on->s)
              : std::tuple(1, std::get<springs::AtAnchor>(end).anchor, 0.0);
  };
  for (springs::Cable& cable : candidates) {
    count_anew(cable.a, places);
    count_anew(cable.b, places);
    if (key(cable.b) < key(cable.a)) std::swap(cable.a, cable.b);
  }
  std::ranges::sort(candidates, {}, [&](const springs::Cable& cable) {
    return std::pair{key(cable.a), key(cable.b)};
  });
}

void count_anew(Problem& problem, const std::vector<Way>& ways) {
  model::Structure& structure = problem.structure;
  const auto places = places_of(structure.rods, ways);
  for (auto& load : structure.point_loads) load.s = places[load.rod].anew(load.s);
  for (auto& arc : problem.rules.forbidden) {
    arc.from = places[arc.rod].anew(arc.from);
    arc.to = places[arc.rod].anew(arc.to);
    if (ways[arc.rod].reversed) std::swap(arc.from, arc.to);
  }
  count_anew(problem.candidates, places);
  count_anew(problem.rules.unwanted, places);
  for (auto& pin : structure.pins)
    if (ways[pin.rod].reversed) pin.vertex = structure.rods[pin.rod].vertices() - 1 - pin.vertex;
  for (std::size_t r = 0; r < ways.size(); ++r) {
    der::Rod& rod = structure.rods[r];
    const Eigen::VectorXd lengths = rod.rest_lengths;
    for (int j = 0; j < rod.edges(); ++j)
      rod.rest_lengths[j] = lengths[edge_before(ways[r], j, rod)];
    problem.target.points[r] = counted_anew(problem.target.points[r], ways[r]);
    problem.start[r].x = counted_anew(problem.start[r].x, ways[r]);
    if (problem.target.weights.empty()) continue;
    const Eigen::VectorXd weights = problem.target.weights[r];
    const auto n = static_cast<int>(weights.size());
    for (int i = 0; i < n; ++i)
      problem.target.weights[r][i] = weights[vertex_before(ways[r], i, n)];
  }
}

void turn(Problem& problem, const Eigen::Matrix3d& by) {
  model::Structure& structure = problem.structure;
  structure.anchors = by * structure.anchors;
  for (auto& load : structure.point_loads) load.force = by * load.force;
  for (auto& load : structure.line_loads) load.force_per_length = by * load.force_per_length;
  for (auto& points : problem.target.points) points = by * points;
  problem.target.views = model::turned(std::move(problem.target.views), by);
  for (auto& rod : problem.start) rod.x = by * rod.x;
}

bool may_count_anew(const Problem& problem) {
  if (problem.symmetry) return false;
  for (int r = 0; r < static_cast<int>(problem.structure.rods.size()); ++r)
    if (!alike_all_along(problem.structure, r)) return false;
  return true;
}

}  // namespace

Canonical::Canonical(const Problem& problem) : problem_(problem) {
  if (!may_count_anew(problem)) return;
  for (std::size_t r = 0; r < problem.structure.rods.size(); ++r)
    ways_.push_back(way_of(problem.target.points[r], problem.structure.rods[r].closed));
  count_anew(problem_, ways_);
  const bool held_apart = std::ranges::any_of(problem.structure.pins, [](const model::Pin& pin) {
    return !std::ranges::all_of(pin.axes, [](bool held) { return held; });
  });
  if (!held_apart) turn_ = turn_of(problem_.target.points, problem.structure.planar);
  turn(problem_, turn_);
}

network::Network Canonical::counted(network::Network network) const {
  if (ways_.empty()) return network;
  const auto places = places_of(network.structure.rods, ways_);
  for (springs::Cable& cable : network.structure.cables) {
    count_anew(cable.a, places);
    count_anew(cable.b, places);
  }
  std::vector<springs::Cable> cables = std::move(network.structure.cables);
  network.structure = problem_.structure;
  network.structure.cables = std::move(cables);
  for (std::size_t r = 0; r < ways_.size(); ++r)
    network.state[r].x = turn_ * counted_anew(network.state[r].x, ways_[r]);
  return network;
}

network::Network Canonical::restored(const network::Network& network,
                                     const model::Structure& bare) const {
  network::Network result{.structure = bare, .state = network.state};
  result.structure.cables = network.structure.cables;
  if (ways_.empty()) return result;
  const auto places = places_of(bare.rods, ways_);
  for (springs::Cable& cable : result.structure.cables)
    for (springs::End* end : {&cable.a, &cable.b})
      if (auto* on = std::get_if<springs::OnRod>(end)) on->s = places[on->rod].before(on->s);
  for (std::size_t r = 0; r < ways_.size(); ++r) {
    const Eigen::Matrix3Xd x = turn_.transpose() * network.state[r].x;
    const auto n = static_cast<int>(x.cols());
    for (int i = 0; i < n; ++i) result.state[r].x.col(vertex_before(ways_[r], i, n)) = x.col(i);
  }
  return result;
}

void Canonical::restore(model::Snapshot& snapshot) const {
  snapshot.cable_ends = turn_.transpose() * snapshot.cable_ends;
  for (auto& points : snapshot.rods) points = turn_.transpose() * points;
}

}  // namespace tencer::elimination
