// Cables: how stiff against the rod and against each other, and how near each other they attach.
#include <cmath>
#include <numbers>
#include <string>

#include "forward.hpp"
#include "groups.hpp"

namespace tencer::app::stress {
namespace {

constexpr int rod_edges = 40;

der::Rod unit_rod() { return slender_rod(false, equal_lengths(rod_edges), 1e3); }

springs::Cable cable(double from, double to, double stiffness, double rest_length) {
  return {.a = springs::OnRod{0, from},
          .b = springs::OnRod{0, to},
          .stiffness = stiffness,
          .rest_length = rest_length};
}

std::string text(double value) {
  const int exponent = static_cast<int>(std::lround(std::log10(value)));
  return "1e" + std::to_string(exponent);
}

// The bow with its string: `cables` carry the load between its ends.
Forward held_by(std::string name, std::vector<springs::Cable> cables, const Bow& answer) {
  const der::Rod rod = unit_rod();
  return {.name = std::move(name),
          .structure = {.rods = {rod}, .cables = std::move(cables)},
          .start = {arch(rod, answer.span, 0.7 * answer.x.row(1).maxCoeff())},
          .known = "shooting, 64-bit mantissa",
          .promise = 1e-9,
          .error = distance_from(answer.x, rod.length())};
}

// A cable between the ends that carries `load` at the bow's span.
springs::Cable string_of(const Bow& answer, double stiffness, double load) {
  return cable(0, 1, stiffness, answer.span - load / stiffness);
}

// A zero-length cable between the ends, below the load that buckles the rod: it stays straight.
Forward compressed_rod(double stiffness) {
  const der::Rod rod = unit_rod();
  const double span = 1 / (1 + stiffness / rod.section.EA);
  Eigen::Matrix3Xd straight = Eigen::Matrix3Xd::Zero(3, rod.vertices());
  straight.row(0).setLinSpaced(0, span);
  return {.name = "cable of " + text(stiffness) + " EI/L^3",
          .structure = {.rods = {rod}, .cables = {cable(0, 1, stiffness, 0)}},
          .start = {arch(rod, 0.95, 0.1)},
          .known = "the compressed straight rod",
          .promise = 1e-9,
          .error = distance_from(straight, 1.0)};
}

}  // namespace

Group soft_and_rigid_cables() {
  Group group{.title = "Cables against the rod's bending"};
  for (double stiffness : {1e-12, 1e-6, 1e-3, 1.0})
    group.rows.push_back(stable(forward(compressed_rod(stiffness))));
  const Bow answer = bow(unit_rod(), thirty_degrees);
  for (double stiffness : {1e2, 1e3, 1e6, 1e9, 1e12})
    group.rows.push_back(
        stable(forward(held_by("cable of " + text(stiffness) + " EI/L^3",
                               {string_of(answer, stiffness, answer.load)}, answer))));
  group.rows.push_back(stable(built(strung_bow("rigid cable", unit_rod(), thirty_degrees, 1e-9))));
  return group;
}

Group cable_ratios() {
  Group group{.title = "Two cables, stiffer : softer"};
  const Bow answer = bow(unit_rod(), thirty_degrees);
  for (double ratio : {1.0, 1e3, 1e6, 1e9, 1e12})
    group.rows.push_back(stable(forward(held_by(
        "1 : " + text(ratio),
        {string_of(answer, 100, answer.load / 2), string_of(answer, 100 * ratio, answer.load / 2)},
        answer))));
  return group;
}

Group near_attachments() {
  Group group{.title = "Nearly coincident attachments (distance / length)"};
  const Bow answer = bow(unit_rod(), thirty_degrees);
  const springs::Cable whole = string_of(answer, 1e3, answer.load);
  const springs::Cable half = string_of(answer, 500, answer.load / 2);
  for (double gap : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    springs::Cable beside = half;
    beside.a = springs::OnRod{0, gap};
    Forward pair = held_by("two cables, " + text(gap), {half, beside}, answer);
    // Moving half the load by gap moves the bow by about as much.
    pair.promise = std::max(gap, 1e-9);
    group.rows.push_back(stable(forward(pair)));
    Forward both = pair;
    both.name = "two rigid cables, " + text(gap);
    for (auto& one : both.structure.cables) one.rest_length = answer.span;
    both.promise = std::max(3 * gap, 1e-8);
    group.rows.push_back(stable(built(both)));
    Forward within = held_by("a cable from s to s + " + text(gap),
                             {whole, cable(0.51, 0.51 + gap, 1e3, 0)}, answer);
    within.promise = std::max(gap, 1e-9);
    group.rows.push_back(stable(forward(within)));
    Forward stiff = within;
    stiff.name = "a strut from s to s + " + text(gap);
    stiff.structure.cables[1].rest_length = gap / 2;
    group.rows.push_back(stable(forward(stiff)));
  }
  return group;
}

}  // namespace tencer::app::stress
