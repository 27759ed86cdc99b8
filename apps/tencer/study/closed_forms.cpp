#include "closed_forms.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <sstream>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>
#include <tencer/io/csv.hpp>
#include <utility>
#include <vector>

namespace tencer::app::study {
namespace {

using equilibrium::System;
using model::Structure;
using std::numbers::pi;

constexpr double EI = 1.0;
constexpr double GJ = 0.8;
constexpr double length = 1.0;
// So slender that stretching, which the closed forms leave out, is below 1e-9.
constexpr der::Section round{.EA = 1e10, .EI1 = EI, .EI2 = EI, .GJ = GJ};

der::Rod rod_of(int edges, bool closed, const der::Section& section = round) {
  return {.closed = closed,
          .section = section,
          .rest_lengths = Eigen::VectorXd::Constant(edges, length / edges)};
}

equilibrium::Equilibrium solved(const System& system, model::State start) {
  auto result = equilibrium::solve(system, std::move(start));
  core::require(result.usable(), "closed forms: a problem has no equilibrium");
  return result;
}

// An ellipse of about the rod's length, with a wave out of its plane.
Eigen::Matrix3Xd bent_ring(int n, double wave) {
  Eigen::Matrix3Xd x(3, n);
  for (int i = 0; i < n; ++i) {
    const double phi = 2 * pi * i / n;
    x.col(i) << 1.1 * std::cos(phi), 0.9 * std::sin(phi), wave * std::cos(2 * phi);
  }
  return x * length / (2 * pi);
}

Eigen::Matrix3Xd straight(int edges, double from, double to) {
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, edges + 1);
  x.row(0) = Eigen::RowVectorXd::LinSpaced(edges + 1, from, to);
  return x;
}

Structure hinged(int edges) {
  return {.rods = {rod_of(edges, false)},
          .pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = edges}}};
}

// The height of a buckled rod whose first edge stands at 60 degrees to the line between its hinges:
// with modulus k = sin(angle / 2) the distance of the hinges is 2 E / K - 1, the height k / K.
double elastica(int edges) {
  const double k = std::sin(pi / 6);
  const double K = std::comp_ellint_1(k);
  Eigen::Matrix3Xd x = straight(edges, 0, 2 * std::comp_ellint_2(k) / K - 1);
  for (int i = 0; i <= edges; ++i) x(1, i) = 0.3 * std::sin(pi * i / edges);
  const System system(hinged(edges));
  const auto result = solved(system, make_state(system.structure(), {x}));
  return result.state[0].x.row(1).maxCoeff() / (k / K) - 1;
}

// The softest mode of a straight rod under half of Euler's load: EI k^4 - P k^2, k = pi / L.
double euler(int edges) {
  const double load = pi * pi * EI / 2;
  const System system(hinged(edges));
  const auto state = make_state(system.structure(), {straight(edges, 0, 1 - load / round.EA)});
  return equilibrium::stability(system, state).smallest_eigenvalue / (std::pow(pi, 4) / 2) - 1;
}

// The energy of a ring that a bent one relaxes to, 2 pi^2 EI / L.
double ring(int edges) {
  const System system(Structure{.rods = {rod_of(edges, true)}});
  const auto result = solved(system, make_state(system.structure(), {bent_ring(edges, 0.1)}));
  return result.energy / (2 * pi * pi * EI) - 1;
}

// The same of a strip, which turns to bend about its weak axis: an angle an edge.
double strip(int edges) {
  Structure structure{.rods = {rod_of(edges, true, {.EA = 1e10, .EI1 = 4, .EI2 = EI, .GJ = GJ})}};
  auto start = make_state(structure, {bent_ring(edges, 0.0)});
  for (int j = 0; j < edges; ++j) {
    const Eigen::Vector3d t = start[0].frames.tangent.col(j);
    const double tilt = 1.0;
    der::set_material_frame(start[0], j,
                            std::cos(tilt) * t.cross(Eigen::Vector3d::UnitZ()) +
                                std::sin(tilt) * Eigen::Vector3d::UnitZ());
  }
  const System system(structure);
  return solved(system, std::move(start)).energy / (2 * pi * pi * EI) - 1;
}

// Where `eigenvalue` of an angle passes through zero, by the secant method.
template <class Eigenvalue>
double critical_angle(double a, double b, const Eigenvalue& eigenvalue) {
  double at_a = eigenvalue(a);
  double at_b = eigenvalue(b);
  for (int step = 0; step < 20 && std::abs(b - a) > 1e-9 * std::abs(b); ++step) {
    const double next = b - at_b * (b - a) / (at_b - at_a);
    a = std::exchange(b, next);
    at_a = std::exchange(at_b, eigenvalue(next));
  }
  return b;
}

// The closing angle at which a twisted ring leaves its plane: 2 pi sqrt(3) EI / GJ (Michell 1889).
double michell(int edges) {
  const double known = 2 * pi * std::sqrt(3.0) * EI / GJ;
  const auto eigenvalue = [&](double angle) {
    Structure structure{.rods = {rod_of(edges, true)}};
    structure.rods[0].closing_angle = angle;
    structure.planar = true;  // in balance also when unstable in space
    const auto flat = solved(System(structure), make_state(structure, {bent_ring(edges, 0.0)}));
    structure.planar = false;
    return equilibrium::stability(System(structure), flat.state).smallest_eigenvalue;
  };
  return critical_angle(0.9 * known, 0.95 * known, eigenvalue) / known - 1;
}

// The angle by which a straight rod between clamps is turned when it buckles: 2 x EI / GJ with
// tan x = x (Greenhill 1883). The clamps' faces are the midpoints of the outer edges.
double greenhill(int edges) {
  const double known = 2 * 4.493409457909064 * EI / GJ;
  const double edge = length / (edges - 1);
  der::Rod rod = rod_of(edges, false);
  rod.rest_lengths.setConstant(edge);
  rod.clamp_start_frame = rod.clamp_end_frame = true;
  Structure structure{.rods = {rod}};
  for (int vertex : {0, 1, edges - 1, edges})
    structure.pins.push_back({.rod = 0, .vertex = vertex});
  const System system(structure);
  const auto eigenvalue = [&](double angle) {
    auto state = make_state(structure, {straight(edges, -edge / 2, length + edge / 2)});
    state[0].theta.setLinSpaced(0.0, angle);
    return equilibrium::stability(system, state).smallest_eigenvalue;
  };
  return critical_angle(0.9 * known, 0.95 * known, eigenvalue) / known - 1;
}

struct Problem {
  const char* name;
  double (*error)(int edges);  // relative, with its sign
};

constexpr Problem problems[] = {{"elastica, height", elastica},
                                {"Euler, softest mode", euler},
                                {"ring, energy", ring},
                                {"strip to a ring, energy", strip},
                                {"twisted ring, Michell's angle", michell},
                                {"twisted rod, Greenhill's angle", greenhill}};

Accuracy measured(const Problem& problem, int edges) {
  constexpr double enough = 0.1;  // seconds
  constexpr int most = 15;
  Accuracy result{.problem = problem.name, .edges = edges};
  std::vector<double> times;
  double sum = 0;
  while (times.empty() || (sum < enough && static_cast<int>(times.size()) < most)) {
    const auto begin = std::chrono::steady_clock::now();
    result.error = std::abs(problem.error(edges));
    times.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    sum += times.back();
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::ranges::nth_element(times, middle);
  result.seconds = *middle;
  return result;
}

}  // namespace

std::vector<Accuracy> closed_form_errors(std::span<const int> edges,
                                         const std::function<void(const Accuracy&)>& progress) {
  std::vector<Accuracy> rows;
  for (const Problem& problem : problems)
    for (const int n : edges) {
      rows.push_back(measured(problem, n));
      if (progress) progress(rows.back());
    }
  return rows;
}

std::string accuracy_text(std::span<const Accuracy> rows) {
  std::string text = "problem,edges,seconds,relative_error\n";
  for (const Accuracy& row : rows) {
    std::ostringstream seconds, error;
    seconds << row.seconds;
    error << row.error;
    text += io::csv_line(
        std::array{row.problem, std::to_string(row.edges), seconds.str(), error.str()});
  }
  return text;
}

}  // namespace tencer::app::study
