// Several rods: of very different stiffness, and nested, linked or free of each other.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "forward.hpp"
#include "groups.hpp"

namespace tencer::app::stress {
namespace {

using std::numbers::pi;

constexpr int bow_edges = 40;

// A soft bow strung on a straight stiff strut: zero-length cables of stiffness 1e3 join their ends.
Forward bow_on_strut(int exponent) {
  const double ratio = std::pow(10.0, exponent);
  const der::Rod soft = slender_rod(false, equal_lengths(bow_edges), 1e3, 1 / ratio);
  const Bow answer = bow(soft, thirty_degrees);
  // The strut stretches and the cables lengthen under the bow's load.
  const double joint = 1e3 / ratio;
  const double strut_length = answer.span - 2 * answer.load / joint;
  der::Rod strut = slender_rod(false, equal_lengths(10, 1.0), 1e3);
  strut.rest_lengths.setConstant(strut_length / (1 + answer.load / strut.section.EA) / 10);
  Eigen::Matrix3Xd line = Eigen::Matrix3Xd::Zero(3, strut.vertices());
  line.row(0).setLinSpaced(0, strut_length);
  const double far = strut.length();
  return {.name = "bow strung on a strut, 1 : 1e" + std::to_string(exponent),
          .structure = {.rods = {strut, soft},
                        .cables = {{.a = springs::OnRod{0, 0},
                                    .b = springs::OnRod{1, 0},
                                    .stiffness = joint},
                                   {.a = springs::OnRod{0, far},
                                    .b = springs::OnRod{1, 1.0},
                                    .stiffness = joint}}},
          .start = {line, arch(soft, answer.span, 0.7 * answer.x.row(1).maxCoeff())},
          .known = "shooting, 64-bit mantissa",
          .promise = 1e-8,
          .error = distance_from(answer.x, 1.0, 1)};
}

// Two bows in a plane, each between its own fixed points; the soft one is compared.
Forward two_bows(int exponent) {
  const double ratio = std::pow(10.0, exponent);
  Forward soft = pinned_bow("two bows not tied together, 1 : 1e" + std::to_string(exponent),
                            slender_rod(false, equal_lengths(bow_edges), 1e3, 1 / ratio),
                            thirty_degrees, 1e-8);
  soft.structure.planar = true;  // or each could turn about the line between its ends
  Eigen::Matrix3Xd beside = soft.start[0];
  beside.row(1).array() += 0.5;
  soft.start.push_back(beside);
  soft.structure.rods.push_back(slender_rod(false, equal_lengths(bow_edges), 1e3));
  soft.structure.pins.push_back({.rod = 1, .vertex = 0});
  soft.structure.pins.push_back({.rod = 1, .vertex = bow_edges});
  return soft;
}

// The worse of two rings, each against the regular polygon.
Error either_polygon(int vertices) {
  const Eigen::Matrix3Xd x = polygon(vertices, 1.0);
  return [first = distance_from(x, 1.0, 0), second = distance_from(x, 1.0, 1)](
             const model::State& state) { return std::max(first(state), second(state)); };
}

// A ring in a larger one, spokes from vertex to vertex pulling with `tension`.
Forward nested_rings(double tension) {
  const int n = 24;
  const double inner_length = 1.0, outer_length = 2.0;
  model::Structure structure{.rods = {slender_rod(true, equal_lengths(n, inner_length), 1e2),
                                      slender_rod(true, equal_lengths(n, outer_length), 1e2)}};
  // Radial balance: the spokes' pull stretches the inner ring's edges and compresses the outer's.
  const double along = tension / (2 * std::sin(pi / n));
  const auto stretched = [&](const der::Rod& rod, double force) {
    return polygon(n, rod.length() * (1 + force / rod.section.EA));
  };
  const Eigen::Matrix3Xd inner = stretched(structure.rods[0], along);
  const Eigen::Matrix3Xd outer = stretched(structure.rods[1], -along);
  const double stiffness = 300;
  const double spoke = outer(0, 0) - inner(0, 0);
  for (int i = 0; i < n; ++i)
    structure.cables.push_back({.a = springs::OnRod{0, i * inner_length / n},
                                .b = springs::OnRod{1, i * outer_length / n},
                                .stiffness = stiffness,
                                .rest_length = spoke - tension / stiffness});
  Eigen::Matrix3Xd start = 1.1 * outer;
  start.row(2).setConstant(0.05);
  return {.name = "nested rings with spokes",
          .structure = structure,
          .start = {polygon(n, inner_length), start},
          .known = "radial balance, closed form",
          .promise = 1e-9,
          .error = distance_from(outer, outer_length, 1)};
}

// Two rings, each through the other, or one far from the other; tied by nothing.
Forward two_rings(std::string name, double distance) {
  const int n = 40;
  model::Structure structure{
      .rods = {slender_rod(true, equal_lengths(n), 1e3), slender_rod(true, equal_lengths(n), 1e3)}};
  Eigen::Matrix3Xd first = polygon(n, 1.0);
  first.row(0) *= 1.2;
  first.row(1) *= 0.8;
  Eigen::Matrix3Xd second = polygon(n, 1.0);
  second.row(2) = second.row(1);
  second.row(1).setZero();
  second.row(0).array() += distance;
  return {.name = std::move(name),
          .structure = structure,
          .start = {first, second},
          .known = "two regular polygons",
          .promise = 1e-9,
          .error = either_polygon(n)};
}

// Linked rings tied by one zero-length cable.
Forward tied_rings() {
  Forward rings = two_rings("linked rings, tied at one point", 0.3);
  rings.structure.cables = {
      {.a = springs::OnRod{0, 0.0}, .b = springs::OnRod{1, 0.5}, .stiffness = 100}};
  return rings;
}

}  // namespace

Group rod_ratios() {
  Group group{.title = "Bending stiffness, softer rod : stiffer rod"};
  for (int exponent : {0, 3, 6, 9, 12}) {
    group.rows.push_back(forward(bow_on_strut(exponent)));
    group.rows.back().stable = true;
    group.rows.push_back(forward(two_bows(exponent)));
  }
  return group;
}

Group arrangements() {
  Group group{.title = "Nested, linked and unconnected rods"};
  group.rows.push_back(forward(nested_rings(1.0)));
  group.rows.back().stable = true;
  Row tied = forward(tied_rings());
  tied.stable = false;  // they turn about the point where they are tied
  group.rows.push_back(tied);
  // That single rods are stable, but not the structure, is for the certificate to say.
  group.rows.push_back(forward(two_rings("linked rings, not tied", 0.16)));
  group.rows.push_back(forward(two_rings("rings far apart, not tied", 1e6)));
  return group;
}

}  // namespace tencer::app::stress
