#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/der/rod.hpp>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/lower_bound/at_least.hpp>
#include <vector>

#include "piercing.hpp"
#include "stretch.hpp"

namespace tencer::lower_bound {
namespace {

// One rod of the structure, and where it is looked at.
struct Subject {
  const der::Rod& rod;
  const Eigen::Matrix3Xd& target;
  double error = 0.0;
  double most_bend = 0.0;     // of a vertex of the poses that are looked at
  std::vector<int> marks{};   // vertices between which there are cells
  std::vector<bool> given{};  // per vertex: not to be met by a stretch
};

int cells(const Subject& subject) {
  return static_cast<int>(subject.marks.size()) - (subject.rod.closed ? 0 : 1);
}

// The vertex of a mark; those of a closed rod go on past its end.
int vertex_of(const Subject& subject, int mark) {
  const int count = static_cast<int>(subject.marks.size());
  return subject.marks[mark % count] + mark / count * subject.rod.vertices();
}

// Vertices of the rod whose displacement is not bounded, or on which something other than cables
// may pull.
std::vector<bool> given_vertices(const model::Structure& structure, const model::Target& target,
                                 int r) {
  const der::Rod& rod = structure.rods[r];
  std::vector<bool> given(rod.vertices(), false);
  const Eigen::VectorXd weights = weights_of(target, r);
  for (int i = 0; i < rod.vertices(); ++i) given[i] = !(weights[i] > 0);
  for (const auto& pin : structure.pins)
    if (pin.rod == r) given[pin.vertex] = true;
  for (const auto& load : structure.point_loads) {
    if (load.rod != r) continue;
    const auto place = model::arc_lengths(structure)[r].locate(load.s);
    given[place.edge] = given[(place.edge + 1) % rod.vertices()] = true;
  }
  return given;
}

// Twice the target's sharpest bend; of a target that hardly bends, a tenth of a radian.
double most_bend(const der::Rod& rod, const Eigen::Matrix3Xd& target) {
  double sharpest = 0.05;
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const int at = rod.bending_vertex(b);
    const Eigen::Vector3d x = target.col(at);
    const Eigen::Vector3d before = x - target.col((at + rod.vertices() - 1) % rod.vertices());
    const Eigen::Vector3d after = target.col((at + 1) % rod.vertices()) - x;
    sharpest = std::max(sharpest, std::atan2(before.cross(after).norm(), before.dot(after)));
  }
  return 2 * sharpest;
}

std::vector<int> even_marks(const der::Rod& rod, int count) {
  std::vector<int> marks;
  const int last = rod.closed ? rod.vertices() : rod.vertices() - 1;
  for (int k = 0; k < count + (rod.closed ? 0 : 1); ++k)
    marks.push_back(static_cast<int>(std::lround(static_cast<double>(k) * last / count)));
  return marks;
}

// Whether the part from mark to mark is known to need a force between them.
bool proven(const Subject& subject, int from, int to) {
  const int first = vertex_of(subject, from);
  const int n = vertex_of(subject, to) - first + 1;
  const auto& section = subject.rod.section;
  Stretch stretch{.target = Eigen::Matrix3Xd(3, n),
                  .rest_lengths = Eigen::VectorXd(n - 1),
                  .error = subject.error,
                  .most_bend = subject.most_bend,
                  .slenderness = section.EA / section.EI1};
  for (int k = 0; k < n; ++k) {
    const int vertex = (first + k) % subject.rod.vertices();
    stretch.target.col(k) = subject.target.col(vertex);
    if (k + 1 < n) stretch.rest_lengths[k] = subject.rod.rest_lengths[vertex];
  }
  return needs_force(stretch);
}

// The last mark that a stretch from `from` may go to: no given vertex is in it.
int last_mark(const Subject& subject, int from) {
  const int end = subject.rod.closed ? from + cells(subject) : cells(subject);
  for (int to = from; to <= end; ++to)
    for (int v = vertex_of(subject, std::max(from, to - 1)); v <= vertex_of(subject, to); ++v)
      if (subject.given[v % subject.rod.vertices()]) return std::max(from, to - 1);
  return end;
}

// The shortest stretches that need a force, from mark to mark. What holds of one holds of all that
// contain it, so that both ends go forward only; where the proof fails of a longer one it is not
// tried again with every length.
std::vector<Interval> shortest_stretches(const Subject& subject, const std::stop_token& stop) {
  std::vector<Interval> found;
  int to = 0;
  bool failed = true;
  for (int from = 0; from < cells(subject) && !stop.stop_requested(); ++from) {
    const int last = last_mark(subject, from);
    int end = std::max(to, from + 1);
    if (end > last || (failed && !proven(subject, from, last))) continue;
    while (end <= last && !stop.stop_requested() && !proven(subject, from, end)) ++end;
    failed = end > last;
    if (failed || stop.stop_requested()) continue;
    to = end;
    if (!found.empty() && found.back().to == to) found.pop_back();  // it contains this one
    found.push_back({from, to});
  }
  return found;
}

// The arc length of a vertex; those of a closed rod go on past its end.
double place(const geometry::ArcLength& along, int vertex) {
  const int rounds = vertex / along.edges();
  return along.closed() ? along.knots()[vertex % along.edges()] + rounds * along.length()
                        : along.knots()[vertex];
}

// Cables pull on a free rod at no place or at two or more.
int fewest_ends(const Subject& subject, const std::vector<Interval>& stretches) {
  const int fewest =
      subject.rod.closed ? fewest_on_circle(stretches, cells(subject)) : fewest_on_line(stretches);
  const bool free = std::ranges::none_of(subject.given, [](bool given) { return given; });
  return fewest == 1 && free ? 2 : fewest;
}

}  // namespace

model::AtLeast at_least(const model::Structure& structure, const model::Target& target,
                        double error_percent, const std::stop_token& stop) {
  constexpr int most_cells = 32;
  validate(target, structure);
  core::require(target.views.empty(), "at_least: a target that is seen from a side has no bound");
  core::require(error_percent > 0, "at_least: the error must be positive");
  model::AtLeast result{.error_percent = error_percent};
  if (!structure.line_loads.empty()) return result;
  const double error = error_percent / 100 * model::diagonal(target);
  const auto along = model::arc_lengths(structure);
  for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r) {
    const der::Rod& rod = structure.rods[r];
    if (twist_model(rod) != der::TwistModel::none) continue;
    const Subject subject{.rod = rod,
                          .target = target.points[r],
                          .error = error,
                          .most_bend = most_bend(rod, target.points[r]),
                          .marks = even_marks(rod, std::min(most_cells, rod.edges())),
                          .given = given_vertices(structure, target, r)};
    const auto stretches = shortest_stretches(subject, stop);
    result.ends += fewest_ends(subject, stretches);
    for (const Interval& interval : stretches)
      result.stretches.push_back({.rod = r,
                                  .from = place(along[r], vertex_of(subject, interval.from)),
                                  .to = place(along[r], vertex_of(subject, interval.to))});
  }
  result.cables = (result.ends + 1) / 2;
  return result;
}

}  // namespace tencer::lower_bound
