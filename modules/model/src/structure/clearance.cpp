#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/model/clearance.hpp>

namespace tencer::model {
namespace {

// From the middle of each edge to that of the arc of constant curvature which it cuts off, h turn /
// 8 away from its chord h.
Eigen::Matrix3Xd bulges(const Eigen::Matrix3Xd& x, int edges) {
  const auto edge = [&](int e) -> Eigen::Vector3d { return x.col((e + 1) % x.cols()) - x.col(e); };
  const bool closed = edges == x.cols();
  Eigen::Matrix3Xd turns = Eigen::Matrix3Xd::Zero(3, edges + 1);  // outwards, at each vertex
  for (int v = closed ? 0 : 1; v < edges; ++v)
    turns.col(v) = edge((v + edges - 1) % edges).normalized() - edge(v).normalized();
  if (closed) turns.col(edges) = turns.col(0);
  Eigen::Matrix3Xd result(3, edges);
  for (int e = 0; e < edges; ++e)
    result.col(e) = edge(e).norm() / 16 * (turns.col(e) + turns.col(e + 1));
  return result;
}

}  // namespace

std::vector<double> outer_radii(const Structure& structure) {
  std::vector<double> radii;
  for (const auto& rod : structure.rods) {
    const der::Section& section = rod.section;
    const auto half = der::half_sizes(section.shape);
    // A circle's is exact without its shape.
    radii.push_back(half ? std::max(half->along_m1, half->along_m2)
                         : 2 * std::sqrt(std::max(section.EI1, section.EI2) / section.EA));
  }
  return radii;
}

std::vector<std::vector<Mark>> marks_along(const std::vector<springs::Cable>& cables,
                                           const std::vector<geometry::ArcLength>& along) {
  std::vector<std::vector<Mark>> marks(along.size());
  for (int c = 0; c < static_cast<int>(cables.size()); ++c)
    for (const int end : {0, 1})
      if (const auto* on = std::get_if<springs::OnRod>(end == 0 ? &cables[c].a : &cables[c].b))
        marks[on->rod].push_back({along[on->rod].wrap(on->s), c, end});
  for (auto& own : marks) std::ranges::stable_sort(own, {}, &Mark::s);
  return marks;
}

std::vector<MarkPair> neighbouring_marks(const std::vector<springs::Cable>& cables,
                                         const std::vector<geometry::ArcLength>& along) {
  const auto marks = marks_along(cables, along);
  std::vector<MarkPair> pairs;
  for (int rod = 0; rod < static_cast<int>(marks.size()); ++rod) {
    const auto& own = marks[rod];
    const bool around = along[rod].closed() && own.size() > 1;
    for (std::size_t i = 0; i + 1 < own.size() + (around ? 1 : 0); ++i) {
      const Mark& second = own[(i + 1) % own.size()];
      const double turn = i + 1 == own.size() ? along[rod].length() : 0.0;
      pairs.push_back({own[i], second, rod, second.s + turn - own[i].s});
    }
  }
  return pairs;
}

CablePasses::CablePasses(const Structure& structure, const State& state, const Gaps& gaps)
    : structure_(structure),
      state_(state),
      gaps_(gaps),
      radii_(outer_radii(structure)),
      along_(arc_lengths(structure)) {
  gaps.validate();
  for (int rod = 0; rod < static_cast<int>(structure.rods.size()); ++rod) {
    bulges_.push_back(bulges(state[rod].x, structure.rods[rod].edges()));
    add_balls(rod);
  }
}

void CablePasses::add_balls(int rod) {
  constexpr int edges_of_ball = 8;
  const int edges = structure_.rods[rod].edges();
  for (int first = 0; first < edges; first += edges_of_ball) {
    Ball ball{.rod = rod, .first = first, .end = std::min(first + edges_of_ball, edges)};
    for (int v = ball.first; v <= ball.end; ++v) ball.centre += vertex(rod, v);
    ball.centre /= ball.end - ball.first + 1;
    ball.bulge = bulges_[rod].middleCols(first, ball.end - first).colwise().norm().maxCoeff();
    for (int v = ball.first; v <= ball.end; ++v)
      ball.radius = std::max(ball.radius, (vertex(rod, v) - ball.centre).norm());
    balls_.push_back(ball);
  }
}

Eigen::Vector3d CablePasses::vertex(int rod, int index) const {
  const auto& x = state_[rod].x;
  return x.col(index % x.cols());
}

Eigen::Vector3d CablePasses::point(const springs::End& end) const {
  if (const auto* anchor = std::get_if<springs::AtAnchor>(&end))
    return structure_.anchors.col(anchor->anchor);
  const auto& on = std::get<springs::OnRod>(end);
  const auto [edge, t] = along_[on.rod].locate(on.s);
  return (1 - t) * vertex(on.rod, edge) + t * vertex(on.rod, edge + 1);
}

// How far to either side of its own ends the cable may be near the rod: between two ends on the
// same rod there is always some of it left to keep clear of.
double CablePasses::own_arc(int rod, const springs::Cable& cable) const {
  const double own = gaps_.own_radii * radii_[rod];
  const auto* a = std::get_if<springs::OnRod>(&cable.a);
  const auto* b = std::get_if<springs::OnRod>(&cable.b);
  if (!a || !b || a->rod != rod || b->rod != rod) return own;
  const geometry::ArcLength& along = along_[rod];
  double apart = std::abs(along.wrap(a->s) - along.wrap(b->s));
  if (along.closed()) apart = std::min(apart, along.length() - apart);
  return std::min(own, apart / 4);
}

// What is left of an edge without the places beside the cable's own ends.
std::vector<CablePasses::Part> CablePasses::parts_of(int rod, int edge,
                                                     const springs::Cable& cable) const {
  const geometry::ArcLength& along = along_[rod];
  const double own = own_arc(rod, cable);
  const double length = along.edge_length(edge);
  std::vector<Part> parts{{}};
  for (const int number : {0, 1}) {
    const auto* on = std::get_if<springs::OnRod>(number == 0 ? &cable.a : &cable.b);
    if (!on || on->rod != rod) continue;
    double s = along.wrap(on->s) - along.knots()[edge];  // from the edge's start
    if (along.closed()) s -= along.length() * std::round((s - length / 2) / along.length());
    const double from = (s - own) / length;
    const double to = (s + own) / length;
    std::vector<Part> left;
    for (const Part& part : parts) {
      if (from > part.from)
        left.push_back(from < part.to ? Part{part.from, from, part.from_end, number} : part);
      if (to < part.to)
        left.push_back(to > part.from ? Part{to, part.to, number, part.to_end} : part);
    }
    parts = std::move(left);
  }
  return parts;
}

std::vector<CablePass> CablePasses::of(const springs::Cable& cable, int number,
                                       double times) const {
  const Eigen::Vector3d a = point(cable.a);
  const Eigen::Vector3d b = point(cable.b);
  std::vector<CablePass> passes;
  struct End {
    int rod = -1;
    double at = 0.0;  // edge + t
  } last;             // of the run of edges that the last pass is in
  for (const Ball& ball : balls_) {
    const double near = times * gaps_.from_axis(radii_[ball.rod]);
    const double least = geometry::segment_approach(a, b, ball.centre, ball.centre).distance -
                         ball.radius - ball.bulge;
    if (least >= near) continue;
    for (int edge = ball.first; edge < ball.end; ++edge) {
      const Eigen::Vector3d start = vertex(ball.rod, edge);
      const Eigen::Vector3d along = vertex(ball.rod, edge + 1) - start;
      for (const Part& part : parts_of(ball.rod, edge, cable)) {
        const auto found =
            geometry::segment_approach(a, b, start + part.from * along, start + part.to * along);
        const double t = part.from + found.t_b * (part.to - part.from);
        CablePass pass{.cable = number,
                       .rod = ball.rod,
                       .edge = edge,
                       .t = t,
                       .u = found.t_a,
                       .distance = found.distance};
        const Eigen::Vector3d gap = a + pass.u * (b - a) - start - t * along;
        pass.away = (found.distance > 0 ? gap : Eigen::Vector3d(along.cross(b - a))).normalized();
        pass.distance -= pass.away.dot(bulges_[ball.rod].col(edge));
        if (pass.distance >= near) continue;
        if (t == part.from) pass.beside_end = part.from_end;
        if (t == part.to) pass.beside_end = part.to_end;
        const bool goes_on = last.rod == ball.rod && last.at == edge + part.from;
        if (!goes_on)
          passes.push_back(pass);
        else if (pass.distance < passes.back().distance)
          passes.back() = pass;
        last = {ball.rod, edge + part.to};
      }
    }
  }
  return passes;
}

}  // namespace tencer::model
