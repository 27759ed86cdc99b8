// Small structures that several tests of the equilibrium module use.
#pragma once

#include <cmath>
#include <numbers>
#include <tencer/model/structure.hpp>

namespace models {

using namespace tencer;

// EI = 1; slenderness sets EA = 4 (L / r)^2 EI / L^2 for a solid circle of radius r.
inline der::Rod slender_rod(bool closed, int vertices, double length, double slenderness = 1e4) {
  const int edges = closed ? vertices : vertices - 1;
  der::Rod rod;
  rod.closed = closed;
  rod.section = {
      .EA = 4 * slenderness * slenderness / (length * length), .EI1 = 1, .EI2 = 1, .GJ = 2.0 / 3};
  rod.rest_lengths = Eigen::VectorXd::Constant(edges, length / edges);
  return rod;
}

inline Eigen::Matrix3Xd straight(int vertices, double length) {
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, vertices);
  x.row(0) = Eigen::RowVectorXd::LinSpaced(vertices, 0, length);
  return x;
}

// A regular polygon of the given circumference.
inline Eigen::Matrix3Xd polygon(int vertices, double circumference) {
  const double radius = circumference / vertices / (2 * std::sin(std::numbers::pi / vertices));
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, vertices);
  for (int i = 0; i < vertices; ++i) {
    const double phi = 2 * std::numbers::pi * i / vertices;
    x.col(i) << radius * std::cos(phi), radius * std::sin(phi), 0;
  }
  return x;
}

// A ring of circumference 1 with a cable across its diameter, from vertex 0 to the one opposite.
inline model::Structure ring_with_cable(int vertices, double stiffness, double rest_length) {
  model::Structure ring;
  ring.rods = {slender_rod(true, vertices, 1.0)};
  ring.cables = {{.a = springs::OnRod{0, 0.0},
                  .b = springs::OnRod{0, 0.5},
                  .stiffness = stiffness,
                  .rest_length = rest_length}};
  return ring;
}

}  // namespace models
