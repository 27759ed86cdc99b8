// One rod: how slender, how finely and how unevenly divided, how sharply bent, in which units.
#include <cmath>
#include <numbers>
#include <string>

#include "forward.hpp"
#include "groups.hpp"

namespace tencer::app::stress {
namespace {

using std::numbers::pi;

std::string power_of_ten(int exponent) { return "1e" + std::to_string(exponent); }

// A ring that starts as an ellipse; at rest it is the regular polygon, whose edges have their rest
// lengths.
Forward ring(std::string name, int vertices, double slenderness, double promise) {
  model::Structure structure{.rods = {slender_rod(true, equal_lengths(vertices), slenderness)}};
  Eigen::Matrix3Xd start = polygon(vertices, 1.0);
  start.row(0) *= 1.2;
  start.row(1) *= 0.8;
  return {.name = std::move(name),
          .structure = structure,
          .start = {start},
          .known = "the regular polygon",
          .promise = promise,
          .error = distance_from(polygon(vertices, 1.0), 1.0)};
}

// An open rod folded in the middle up to an angle; nothing holds it so.
Forward released_fold(double gap) {
  const int edges = 20;
  model::Structure structure{.rods = {slender_rod(false, equal_lengths(edges), 1e3)}};
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, edges + 1);
  for (int i = 0; i <= edges; ++i) {
    const double s = static_cast<double>(i) / edges;
    x.col(i) << std::min(s, 1 - s) * std::cos(gap / 2), (s - 0.5) * std::sin(gap / 2), 0;
  }
  Eigen::Matrix3Xd straight = Eigen::Matrix3Xd::Zero(3, edges + 1);
  straight.row(0).setLinSpaced(0, 1);
  return {.name = "let go",
          .structure = std::move(structure),
          .start = {x},
          .known = "the straight rod",
          .promise = 1e-9,
          .error = distance_from(straight, 1.0)};
}

// Three vertices, the outer ones held so near each other that the edges enclose about `gap`, in a
// rod so slender that the fold does not crush it.
Forward held_fold(double gap) {
  const der::Rod rod = slender_rod(false, equal_lengths(2), 1e3 / gap);
  Forward held = pinned_bow("held", rod, (pi - gap) / 2, 1e-9);
  held.start[0](1, 1) *= 1.01;
  return held;
}

}  // namespace

Group slenderness() {
  Group group{.title = "Slenderness (length / radius)"};
  for (int exponent = 1; exponent <= 6; ++exponent) {
    const double slenderness = std::pow(10.0, exponent);
    group.rows.push_back(stable(forward(
        pinned_bow("bow, " + power_of_ten(exponent),
                   slender_rod(false, equal_lengths(40), slenderness), thirty_degrees, 1e-9))));
    group.rows.push_back(
        stable(forward(ring("ring, " + power_of_ten(exponent), 40, slenderness, 1e-9))));
    group.rows.push_back(stable(built(
        strung_bow("bow with a rigid string, " + power_of_ten(exponent),
                   slender_rod(false, equal_lengths(40), slenderness), thirty_degrees, 1e-9))));
  }
  return group;
}

Group vertex_counts() {
  Group group{.title = "Vertices of a rod"};
  for (int vertices : {3, 4, 100, 1000, 10000, 100000}) {
    const std::string count = std::to_string(vertices) + " vertices";
    const double promise = vertices > 1000 ? 1e-6 : 1e-9;
    group.rows.push_back(stable(
        forward(pinned_bow("bow, " + count, slender_rod(false, equal_lengths(vertices - 1), 1e3),
                           thirty_degrees, promise))));
    group.rows.push_back(stable(forward(ring("ring, " + count, vertices, 1e3, promise))));
  }
  return group;
}

Group uneven_edges() {
  Group group{.title = "Edges of one rod, shortest : longest"};
  const int edges = 40;
  for (int exponent : {1, 2, 3, 4}) {
    const double ratio = std::pow(10.0, exponent);
    Eigen::VectorXd graded(edges), alternating(edges);
    for (int i = 0; i < edges; ++i) {
      graded[i] = std::pow(ratio, static_cast<double>(i) / (edges - 1));
      alternating[i] = i % 2 == 0 ? 1.0 : ratio;
    }
    const std::string text = "1 : " + power_of_ten(exponent);
    for (const auto& [name, lengths] :
         {std::pair{"graded, ", graded}, {"alternating, ", alternating}})
      group.rows.push_back(stable(forward(pinned_bow(
          name + text, slender_rod(false, lengths / lengths.sum(), 1e3), thirty_degrees, 1e-8))));
  }
  return group;
}

Group folds() {
  Group group{.title = "Nearly folded (the angle that two edges enclose)"};
  for (int exponent : {-1, -2, -4, -6, -9}) {
    const double gap = std::pow(10.0, exponent);
    Forward released = released_fold(gap);
    released.name += ", " + power_of_ten(exponent);
    group.rows.push_back(stable(forward(released)));
    Forward held = held_fold(gap);
    held.name += ", " + power_of_ten(exponent);
    group.rows.push_back(stable(forward(held)));
  }
  Forward flat = released_fold(0.0);
  flat.name = "folded flat at the start";
  group.rows.push_back(forward(flat));
  return group;
}

Group units() {
  Group group{.title = "Units"};
  const std::pair<const char*, double> per_metre[] = {{"nm", 1e9}, {"m", 1.0}, {"km", 1e-3}};
  for (const auto& [unit, scale] : per_metre) {
    der::Rod rod = slender_rod(false, equal_lengths(40, scale), 1e3);
    // The same rod: forces in N, lengths in the unit.
    rod.section = {.EA = 4e6, .EI1 = scale * scale, .EI2 = scale * scale, .GJ = scale * scale};
    group.rows.push_back(stable(
        forward(pinned_bow(std::string("bow of 1 m in ") + unit, rod, thirty_degrees, 1e-9))));
  }
  return group;
}

}  // namespace tencer::app::stress
