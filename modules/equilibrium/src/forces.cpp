#include "forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tencer/der/energy.hpp>

namespace tencer::equilibrium {
namespace {

double bending(const der::Rod& rod) { return std::max(rod.section.EI1, rod.section.EI2); }

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

// |v| over the free unknowns of each rod.
Eigen::VectorXd norms(const System& system, const Eigen::VectorXd& v) {
  const auto rods = static_cast<Eigen::Index>(system.structure().rods.size());
  Eigen::VectorXd squared = Eigen::VectorXd::Zero(rods);
  for (int r = 0; r < rods; ++r) {
    const int unknowns = der::unknowns(system.structure().rods[r]);
    for (int i = 0; i < unknowns; ++i)
      if (const int at = system.index(r, i); at >= 0) squared[r] += v[at] * v[at];
  }
  return squared.cwiseSqrt();
}

struct Stiffness {
  double coordinate, twist;
};

// of_rod(rod) for each of the rod's free unknowns; 0 for twisting moments.
template <class OfRod>
Eigen::VectorXd per_unknown(const System& system, const OfRod& of_rod) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(system.size());
  for (int r = 0; r < static_cast<int>(system.structure().rods.size()); ++r) {
    const auto& rod = system.structure().rods[r];
    const Stiffness stiffness = of_rod(rod);
    const int coordinates = 3 * rod.vertices();
    const bool has_moment = der::twist_model(rod) == der::TwistModel::uniform;
    for (int i = 0; i < der::unknowns(rod); ++i)
      if (const int at = system.index(r, i); at >= 0)
        result[at] = i < coordinates ? stiffness.coordinate : has_moment ? 0 : stiffness.twist;
  }
  return result;
}

}  // namespace

double relative_residual(const System& system, const Eigen::VectorXd& gradient,
                         const Eigen::VectorXd& rod_gradient) {
  const auto rods = static_cast<Eigen::Index>(system.structure().rods.size());
  return relative_residual(system, gradient, rod_gradient, Eigen::VectorXd::Zero(rods));
}

double relative_residual(const System& system, const Eigen::VectorXd& gradient,
                         const Eigen::VectorXd& rod_gradient, const Eigen::VectorXd& explained) {
  const Eigen::VectorXd imbalance = norms(system, gradient) - explained;
  const Eigen::VectorXd internal =
      norms(system, system.load_gradient().size() > 0
                        ? Eigen::VectorXd(rod_gradient - system.load_gradient())
                        : rod_gradient);
  double largest = 0;
  for (Eigen::Index r = 0; r < imbalance.size(); ++r) {
    const auto& rod = system.structure().rods[r];
    const double length = rod.length();
    const double relative = imbalance[r] / (internal[r] + bending(rod) / (length * length));
    if (!(relative <= largest)) largest = relative;  // NaN passes through
  }
  return largest;
}

ForceBalance force_balance(const System& system, const model::State& state) {
  const Eigen::VectorXd rods = system.rod_gradient(state);
  ForceBalance balance{.gradient = rods};
  system.add_cable_gradient(state, balance.gradient);
  balance.residual = relative_residual(system, balance.gradient, rods);
  return balance;
}

Eigen::VectorXd gradient_rounding(const System& system, const model::State& state) {
  const auto& structure = system.structure();
  const auto rods = static_cast<Eigen::Index>(structure.rods.size());
  Eigen::VectorXd largest(rods), squared(rods);
  for (Eigen::Index r = 0; r < rods; ++r) {
    const auto& rod = structure.rods[r];
    largest[r] = state[r].x.cwiseAbs().maxCoeff();
    const auto lengths = rod.rest_lengths.array();
    const auto stiffness = rod.section.EA / lengths + 8 * bending(rod) / lengths.cube();
    squared[r] = (largest[r] * stiffness).square().sum();
  }
  for (std::size_t c = 0; c < structure.cables.size(); ++c) {
    const auto& stencil = system.stencils()[c];
    double extent = stencil.offset.norm();
    for (int i = 0; i < stencil.count; ++i)
      extent = std::max(extent, largest[stencil.shares[i].rod]);
    for (int i = 0; i < stencil.count; ++i) {
      const double rounding = structure.cables[c].stiffness * extent * stencil.shares[i].weight;
      squared[stencil.shares[i].rod] += rounding * rounding;
    }
  }
  return 4 * std::numeric_limits<double>::epsilon() * squared.cwiseSqrt();
}

bool is_rounding(const System& system, const model::State& state, const Eigen::VectorXd& gradient) {
  return (norms(system, gradient).array() <= gradient_rounding(system, state).array()).all();
}

double energy_rounding(const System& system, const model::State& state) {
  const InternalForces forces = system.internal_forces(state);
  double squared = 0;
  double extent = 0;
  for (std::size_t r = 0; r < state.size(); ++r) {
    const auto& rod = system.structure().rods[r];
    extent = std::max(extent, state[r].x.cwiseAbs().maxCoeff());
    squared += forces.axial[r].squaredNorm();
    for (int b = 0; b < rod.bending_vertices(); ++b) {
      const int at = rod.bending_vertex(b);
      const int before = at > 0 ? at - 1 : rod.vertices() - 1;
      const Eigen::Vector3d e = state[r].x.col(at) - state[r].x.col(before);
      const Eigen::Vector3d f = state[r].x.col(next_vertex(rod, at)) - state[r].x.col(at);
      const double shortest = std::min(rod.rest_lengths[before], rod.rest_lengths[at]);
      const double force =
          bending(rod) * (e.normalized() - f.normalized()).norm() / (shortest * shortest);
      squared += force * force;
    }
  }
  squared += forces.tension.squaredNorm();
  return 4 * std::numeric_limits<double>::epsilon() * extent * std::sqrt(squared);
}

double curvature_rounding(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& d) {
  return 8 * std::numeric_limits<double>::epsilon() * diagonal.cwiseProduct(d.cwiseAbs2()).norm();
}

Eigen::VectorXd softest_stiffness(const System& system) {
  return per_unknown(system, [](const der::Rod& rod) {
    const double length = rod.length();
    return Stiffness{.coordinate = bending(rod) / (length * length * length),
                     .twist = bending(rod) / length};
  });
}

Eigen::VectorXd edge_stiffness(const System& system) {
  return per_unknown(system, [](const der::Rod& rod) {
    const double l = rod.length() / rod.edges();
    return Stiffness{.coordinate = std::sqrt(rod.section.EA * bending(rod)) / (l * l),
                     .twist = bending(rod) / l};
  });
}

double largest_motion(const System& system, const Eigen::VectorXd& step) {
  double largest = 0;
  const auto& rods = system.structure().rods;
  for (int r = 0; r < static_cast<int>(rods.size()); ++r)
    for (int v = 0; v < rods[r].vertices(); ++v)
      largest = std::max(largest, step_of(system, step, r, v).norm());
  return largest;
}

double largest_rotation(const System& system, const model::State& state,
                        const Eigen::VectorXd& step) {
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

InternalForces predicted_forces(const System& system, const model::State& state,
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
    const double predicted =
        forces.tension[static_cast<Eigen::Index>(c)] +
        cable.stiffness * model::span_of(stencil, state).normalized().dot(change);
    forces.tension[static_cast<Eigen::Index>(c)] =
        cable.tension_only ? std::max(0.0, predicted) : predicted;
  }
  return forces;
}

}  // namespace tencer::equilibrium
