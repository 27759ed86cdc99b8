#include "forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tencer::equilibrium {
namespace {

struct Size {
  double bending = 0.0;  // largest EI
  double length = 0.0;   // of all rods
};

Size size_of(const Structure& structure) {
  Size size;
  for (const auto& rod : structure.rods) {
    size.bending = std::max({size.bending, rod.section.EI1, rod.section.EI2});
    size.length += rod.length();
  }
  return size;
}

int next_vertex(const der::Rod& rod, int j) { return j + 1 < rod.vertices() ? j + 1 : 0; }

// The step of one vertex; held coordinates do not move.
Eigen::Vector3d step_of(const System& system, const Eigen::VectorXd& step, int rod, int vertex) {
  Eigen::Vector3d d;
  for (int axis = 0; axis < 3; ++axis) {
    const int at = system.position_index(rod, vertex, axis);
    d[axis] = at >= 0 ? step[at] : 0.0;
  }
  return d;
}

}  // namespace

double relative_residual(const System& system, const Eigen::VectorXd& gradient,
                         const Eigen::VectorXd& rod_gradient) {
  const Size size = size_of(system.structure());
  const double internal = system.load_gradient().size() > 0
                              ? (rod_gradient - system.load_gradient()).norm()
                              : rod_gradient.norm();
  return gradient.norm() / (internal + size.bending / (size.length * size.length));
}

ForceBalance force_balance(const System& system, const State& state) {
  const Eigen::VectorXd rods = system.rod_gradient(state);
  ForceBalance balance{.gradient = rods};
  system.add_cable_gradient(state, balance.gradient);
  balance.residual = relative_residual(system, balance.gradient, rods);
  return balance;
}

double gradient_rounding(const System& system, const State& state) {
  double squared = 0;
  double extent = 0;
  for (std::size_t r = 0; r < state.size(); ++r) {
    const auto& rod = system.structure().rods[r];
    const double largest = state[r].x.cwiseAbs().maxCoeff();
    squared += (rod.section.EA * largest / rod.rest_lengths.array()).square().sum();
    extent = std::max(extent, largest);
  }
  for (const auto& cable : system.structure().cables)
    squared += cable.stiffness * cable.stiffness * extent * extent;
  return std::numeric_limits<double>::epsilon() * std::sqrt(squared);
}

double largest_bending(const Structure& structure) { return size_of(structure).bending; }

double softest_stiffness(const Structure& structure) {
  const Size size = size_of(structure);
  return size.bending / (size.length * size.length * size.length);
}

double largest_rotation(const System& system, const State& state, const Eigen::VectorXd& step) {
  double largest = 0;
  for (int r = 0; r < static_cast<int>(state.size()); ++r) {
    const auto& rod = system.structure().rods[r];
    for (int j = 0; j < rod.edges(); ++j) {
      const int next = next_vertex(rod, j);
      const Eigen::Vector3d change = step_of(system, step, r, next) - step_of(system, step, r, j);
      const Eigen::Vector3d edge = state[r].x.col(next) - state[r].x.col(j);
      largest = std::max(largest, change.norm() / edge.norm());
    }
  }
  return largest;
}

InternalForces predicted_forces(const System& system, const State& state,
                                const Eigen::VectorXd& step) {
  InternalForces forces = system.internal_forces(state);
  for (int r = 0; r < static_cast<int>(state.size()); ++r) {
    const auto& rod = system.structure().rods[r];
    for (int j = 0; j < rod.edges(); ++j) {
      const int next = next_vertex(rod, j);
      const Eigen::Vector3d t = (state[r].x.col(next) - state[r].x.col(j)).normalized();
      const Eigen::Vector3d change = step_of(system, step, r, next) - step_of(system, step, r, j);
      forces.axial[r][j] += rod.section.EA / rod.rest_lengths[j] * t.dot(change);
    }
  }
  for (std::size_t c = 0; c < system.stencils().size(); ++c) {
    const auto& cable = system.structure().cables[c];
    const auto& stencil = system.stencils()[c];
    const Eigen::Vector3d change =
        springs::span_of({.shares = stencil.shares, .count = stencil.count},
                         [&](int rod, int vertex) { return step_of(system, step, rod, vertex); });
    const double predicted = forces.tension[static_cast<Eigen::Index>(c)] +
                             cable.stiffness * span_of(stencil, state).normalized().dot(change);
    forces.tension[static_cast<Eigen::Index>(c)] =
        cable.tension_only ? std::max(0.0, predicted) : predicted;
  }
  return forces;
}

}  // namespace tencer::equilibrium
