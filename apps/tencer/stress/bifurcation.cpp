// Straight rods pressed to within 1e-9 of the load at which they buckle.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "forward.hpp"
#include "groups.hpp"

namespace tencer::app::stress {
namespace {

using std::numbers::pi;

constexpr int column_edges = 20;

// Slender enough to buckle and thick enough that eps EA, the rounding of its axial force, is below
// 1e-9 of the load.
der::Rod column(double length = 1.0) {
  return slender_rod(false, equal_lengths(column_edges, length), 100);
}

// 2 - 2 cos(pi / n), the first eigenvalue of the second difference.
double first_difference_eigenvalue() {
  const double half = std::sin(pi / (2 * column_edges));
  return 4 * half * half;
}

// The load P at which the straight chain buckles: P e = EI / l (2 - 2 cos(pi / n)) with the
// compressed edge e = l (1 - P / EA).
double critical_load(const der::Rod& rod) {
  const double l = rod.rest_lengths[0];
  const double free = rod.section.EI1 / (l * l) * first_difference_eigenvalue();
  return 2 * free / (1 + std::sqrt(1 - 4 * free / rod.section.EA));
}

Eigen::Matrix3Xd compressed(const der::Rod& rod, double load) {
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, rod.vertices());
  const double edge = rod.rest_lengths[0] * (1 - load / rod.section.EA);
  for (int i = 0; i < rod.vertices(); ++i) x(0, i) = i * edge;
  return x;
}

// The smallest eigenvalue at the straight state: of the mode sin(pi i / n).
double eigenvalue(const der::Rod& rod, double load) {
  const double l = rod.rest_lengths[0];
  const double e = l * (1 - load / rod.section.EA);
  const double s = first_difference_eigenvalue();
  const double stiffness = rod.section.EI1 / l * (s / e) * (s / e) - load * s / e;
  const double L = rod.length();
  return stiffness / l * L * L * L * L / rod.section.EI1;
}

model::Structure hinged(const der::Rod& rod) {
  return {.rods = {rod}, .pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = column_edges}}};
}

std::string distance_text(double distance) {
  char text[32];
  std::snprintf(text, sizeof text, "1 %c %.0e", distance < 0 ? '-' : '+', std::abs(distance));
  return distance == 0 ? "1" : text;
}

// The certificate of the straight state itself.
Row certificate(double distance, double length = 1.0) {
  const der::Rod rod = column(length);
  const double load = critical_load(rod) * (1 + distance);
  const equilibrium::System system(hinged(rod));
  const auto state = model::make_state(system.structure(), {compressed(rod, load)});
  const auto stability = equilibrium::stability(system, state);
  Row row{.name = "straight state, certificate at " + distance_text(distance),
          .known = "eigenvalue, closed form, in units of the free rod's",
          .promise = 1e-11,
          .residual = equilibrium::residual(system, state),
          .claims_answer = stability.computed,
          .claims_stable = stability.stable(),
          .finite = std::isfinite(stability.smallest_eigenvalue)};
  if (distance != 0) row.stable = distance < 0;
  if (stability.computed)
    row.error = std::abs(stability.smallest_eigenvalue - eigenvalue(rod, load)) / std::pow(pi, 4);
  row.report = !stability.computed      ? "the eigenvalue could not be computed"
               : stability.stable()     ? "certificate: stable"
               : stability.negative > 0 ? "certificate: unstable"
                                        : "certificate: neutral";
  return row;
}

// Newton's method from the straight state.
Row solved(double distance) {
  const der::Rod rod = column();
  const double load = critical_load(rod) * (1 + distance);
  Forward straight{.name = "straight state, solved from at " + distance_text(distance),
                   .structure = hinged(rod),
                   .start = {compressed(rod, load)},
                   .known = "straight, or the bow beyond",
                   .promise = 1e-6,
                   .error = {}};
  return forward(straight);
}

// The bow just past the load: buckled by `angle`.
Row buckled(double angle) {
  const der::Rod rod = column();
  Forward bowed = pinned_bow("", rod, angle, 1e-9);
  const double excess = (1 - pinned_bow("", rod, angle, 0).start[0](0, column_edges)) *
                            rod.section.EA / critical_load(rod) -
                        1;
  char text[64];
  std::snprintf(text, sizeof text, "bow at 1 + %.0e", excess);
  bowed.name = text;
  Row row = forward(bowed);
  row.stable = true;
  return row;
}

}  // namespace

Group bifurcations() {
  Group group{.title = "Next to a bifurcation (load : Euler's)"};
  for (double distance : {-1e-3, -1e-6, -1e-9, 0.0, 1e-9, 1e-6, 1e-3})
    group.rows.push_back(certificate(distance));
  group.rows.push_back(certificate(1e-3, 1e9));
  group.rows.back().name += ", in nm";
  for (double distance : {-1e-3, -1e-6, -1e-9, 0.0, 1e-9, 1e-6, 1e-3})
    group.rows.push_back(solved(distance));
  for (double angle : {1e-2, 1e-4, 1e-6}) group.rows.push_back(buckled(angle));
  return group;
}

}  // namespace tencer::app::stress
