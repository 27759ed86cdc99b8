// First, second and third derivatives against differences, at states of every kind.
#include <tencer/equilibrium/system.hpp>
#include <tencer/geometry/polyline.hpp>
#include <tencer/sensitivity/parameters.hpp>

#include "generators.hpp"

using namespace tencer;
using namespace tencer::property;
using equilibrium::System;
using model::State;

namespace {

// d/dt f(t) at 0, sixth order.
template <class F>
auto difference(F&& f, double h) {
  using Value = decltype(f(h));
  const Value sum = 45 * (f(h) - f(-h)) - 9 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h));
  return Value(sum / (60 * h));
}

Eigen::MatrixXd hessian(const System& system, const State& state) {
  linalg::SymmetricMatrix matrix = system.pattern();
  system.hessian(state, system.internal_forces(state), matrix);
  return Eigen::MatrixXd(matrix).selfadjointView<Eigen::Lower>();
}

// No tension-only cable close to where it goes slack, for there the second derivative jumps, and no
// cable so short that its direction turns with every step, unless it has no rest length.
bool is_smooth(const System& system, const State& state) {
  const auto& cables = system.structure().cables;
  for (std::size_t i = 0; i < cables.size(); ++i) {
    const double length = model::span_of(system.stencils()[i], state).norm();
    if (cables[i].rest_length > 0 && length < 0.1) return false;
    if (cables[i].tension_only && std::abs(length - cables[i].rest_length) < 0.05) return false;
  }
  return true;
}

// How far vertices may move before an edge vanishes or two fold onto each other.
double room(const Posed& a) {
  double least = 1;
  for (std::size_t r = 0; r < a.x.size(); ++r) {
    const der::Rod& rod = a.structure.rods[r];
    const Eigen::Matrix3Xd edges = geometry::edge_vectors({a.x[r], rod.closed});
    for (int b = 0; b < rod.bending_vertices(); ++b) {
      const int at = rod.bending_vertex(b);
      const Eigen::Vector3d e = edges.col(at > 0 ? at - 1 : rod.edges() - 1), f = edges.col(at);
      const double shorter = std::min(e.norm(), f.norm());
      least = std::min(least, shorter * (e.normalized() + f.normalized()).norm());
    }
  }
  return least;
}

// A direction in free unknowns, largest entry 1, in which uniform twisting moments follow as they
// must for the energy.
Eigen::VectorXd direction(const System& system, const Eigen::MatrixXd& h) {
  Eigen::VectorXd v = numbers(system.size(), -1, 1);
  const auto& rods = system.structure().rods;
  for (int r = 0; r < static_cast<int>(rods.size()); ++r) {
    if (der::twist_model(rods[r]) != der::TwistModel::uniform) continue;
    const int moment = system.index(r, 3 * rods[r].vertices());
    v[moment] = 0;
    v[moment] = -h.row(moment).dot(v) / h(moment, moment);
  }
  return v;
}

// sum c_k f(k h) that is f'(0) to fifth order, from one side.
template <class F>
Eigen::VectorXd forward_difference(F&& f, double h) {
  const Eigen::VectorXd sum =
      -137 * f(0.0) + 300 * f(h) - 300 * f(2 * h) + 200 * f(3 * h) - 75 * f(4 * h) + 12 * f(5 * h);
  return sum / (60 * h);
}

// Every parameter of the cables but places closer than `step` below a vertex, and rest lengths
// where the force that they call for has hardly a direction.
std::vector<springs::Parameter> parameters_of(const System& system, const State& state,
                                              double step) {
  using springs::ParameterKind;
  std::vector<springs::Parameter> result;
  const auto& cables = system.structure().cables;
  const auto has_room = [&](const springs::End& end) {
    const auto* on_rod = std::get_if<springs::OnRod>(&end);
    if (on_rod == nullptr) return false;
    const geometry::ArcLength& rod = system.arc_lengths()[on_rod->rod];
    if (!rod.closed() && on_rod->s < 0) return false;  // off the rod, so it does not move
    const geometry::Location at = rod.locate(on_rod->s);
    return at.t * rod.edge_length(at.edge) + step < rod.edge_length(at.edge);
  };
  for (int c = 0; c < static_cast<int>(cables.size()); ++c) {
    result.push_back({ParameterKind::stiffness, c});
    if (model::span_of(system.stencils()[c], state).norm() > 0.1)
      result.push_back({ParameterKind::rest_length, c});
    if (has_room(cables[c].a)) result.push_back({ParameterKind::position_a, c});
    if (has_room(cables[c].b)) result.push_back({ParameterKind::position_b, c});
  }
  return result;
}

// The system with parameter j at t more.
System changed(const System& system, std::span<const springs::Parameter> parameters, Eigen::Index j,
               double t) {
  model::Structure structure = system.structure();
  Eigen::VectorXd p = sensitivity::values(structure.cables, parameters);
  p[j] += t;
  structure.cables = sensitivity::with_values(structure.cables, parameters, p);
  return System(structure);
}

}  // namespace

TEST_CASE("a structure's derivatives match differences of its energy") {
  rc::prop("gradient and Hessian, of rods straight, bent and nearly folded", [] {
    const Posed a = posed(rod_wish);
    const System system(a.structure);
    const State state = a.state();
    RC_PRE(is_smooth(system, state));
    const Eigen::MatrixXd h = hessian(system, state);
    const Eigen::VectorXd v = direction(system, h), gradient = system.gradient(state);
    const auto energy = [&](double t) { return system.energy(system.displaced(state, t * v)); };
    const double step = 1e-3 * room(a);
    // Relative to the sum of all that may cancel in them.
    const double first = difference(energy, step);
    RC_ASSERT(std::abs(first - gradient.dot(v)) <=
              1e-7 * gradient.cwiseAbs().dot(v.cwiseAbs()) + 1e-9);
    // Steps along one line add up exactly, frames and all.
    const auto slope = [&](double t) {
      return system.gradient(system.displaced(state, t * v)).dot(v);
    };
    const double second = difference(slope, step);
    RC_ASSERT(std::abs(second - v.dot(h * v)) <=
              1e-7 * v.cwiseAbs().dot(h.cwiseAbs() * v.cwiseAbs()) + 1e-9);
  });
}

TEST_CASE("derivatives in the cables' parameters match differences") {
  rc::prop("of forces, and of what they depend on; also at vertices and the seam", [] {
    const Posed a = posed(rod_wish);
    const System system(a.structure);
    const State state = a.state();
    RC_PRE(is_smooth(system, state) && !a.structure.cables.empty());
    constexpr double h = 1e-3;
    const auto parameters = parameters_of(system, state, 5 * h);
    const Eigen::VectorXd y = numbers(system.size(), -1, 1), v = numbers(system.size(), -1, 1);
    const Eigen::MatrixXd forces = sensitivity::force_derivatives(system, state, parameters);
    const auto transposed = [&](const System& at, const State& there) {
      return sensitivity::force_derivatives_transposed(at, there, parameters, y);
    };
    RC_ASSERT(largest(transposed(system, state) - forces.transpose() * y) <=
              1e-12 * (1 + forces.cwiseAbs().sum()));
    const auto curvature = sensitivity::force_curvature(system, state, parameters, y);
    const Eigen::MatrixXd mixed = curvature.mixed, second = curvature.parameters;
    for (Eigen::Index j = 0; j < forces.cols(); ++j) {
      const Eigen::VectorXd force = forward_difference(
          [&](double t) { return changed(system, parameters, j, t).gradient(state); }, h);
      // What cancels in the differences: the forces of the rods.
      const double rounding = 1e-12 * largest(system.gradient(state)) / h;
      RC_ASSERT(largest(force - forces.col(j)) <= 1e-6 * (1 + largest(forces.col(j))) + rounding);
      const Eigen::VectorXd column = forward_difference(
          [&](double t) { return transposed(changed(system, parameters, j, t), state); }, h);
      RC_ASSERT(largest(column - second.col(j)) <= 1e-6 * (1 + largest(second)));
    }
    RC_ASSERT(largest(second - second.transpose()) <= 1e-10 * (1 + largest(second)));
    const double step = 1e-3 * room(a);
    const Eigen::VectorXd along = difference(
        [&](double t) -> Eigen::VectorXd {
          return transposed(system, system.displaced(state, t * v));
        },
        step);
    RC_ASSERT(largest(along - mixed.transpose() * v) <= 1e-6 * (1 + mixed.cwiseAbs().sum()));
  });
}

TEST_CASE("third derivatives match differences of Hessians") {
  rc::prop("rods without angles, with cables", [] {
    const Posed a = posed([] { return RodWish{.closed = coin()}; });
    const System system(a.structure);
    const State state = a.state();
    RC_PRE(is_smooth(system, state));
    const Eigen::VectorXd y = numbers(system.size(), -1, 1), v = numbers(system.size(), -1, 1);
    const double step = 1e-3 * room(a);
    const auto times = [&](double t) -> Eigen::VectorXd {
      return hessian(system, system.displaced(state, t * v)) * y;
    };
    const Eigen::VectorXd differences = difference(times, step);
    const Eigen::VectorXd third = sensitivity::third_derivative_times(system, state, y, v);
    // Entries near a fold are large and cancel.
    const double scale = hessian(system, state).cwiseAbs().maxCoeff() / room(a);
    RC_ASSERT(largest(third - differences) <= 1e-7 * scale);
  });
}
