#include <array>
#include <tencer/core/error.hpp>
#include <tencer/der/energy.hpp>
#include <tencer/sensitivity/parameters.hpp>
#include <tencer/springs/derivatives.hpp>
#include <tencer/springs/law.hpp>

namespace tencer::sensitivity {
namespace {

using equilibrium::State;
using equilibrium::System;

// The field of a cable that a parameter stands for.
template <class Cable>
auto& field(Cable& cable, Kind kind) {
  switch (kind) {
    case Kind::stiffness:
      return cable.stiffness;
    case Kind::rest_length:
      return cable.rest_length;
    case Kind::position_a:
    case Kind::position_b:
      break;
  }
  auto* on_rod = std::get_if<springs::OnRod>(kind == Kind::position_a ? &cable.a : &cable.b);
  core::require(on_rod != nullptr, "parameter: an anchored end has no position on a rod");
  return on_rod->s;
}

void check(std::span<const springs::Cable> cables, const Parameter& parameter) {
  core::require(parameter.cable >= 0 && parameter.cable < static_cast<int>(cables.size()),
                "parameter: no such cable");
}

springs::Attachment attachment(Kind kind) {
  return kind == Kind::position_a ? springs::Attachment::a : springs::Attachment::b;
}

// One cable at a state, and directions in which its vertices and its parameters move.
class CableAt {
 public:
  CableAt(const System& system, const State& state, int cable)
      : system_(system),
        state_(state),
        cable_(system.structure().cables[cable]),
        stencil_(system.stencils()[cable]),
        span_(equilibrium::span_of(stencil_, state)) {}

  const springs::Cable& cable() const { return cable_; }
  const springs::Stencil& stencil() const { return stencil_; }
  const Eigen::Vector3d& span() const { return span_; }

  std::array<double, 4> rates(Kind kind) const {
    return springs::weight_rates(cable_, stencil_, system_.arc_lengths(), attachment(kind));
  }
  // How the span changes with s, the vertices held.
  Eigen::Vector3d span_rate(const std::array<double, 4>& rates) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < stencil_.count; ++i) {
      const auto& share = stencil_.shares[i];
      sum += rates[i] * state_[share.rod].x.col(share.vertex);
    }
    return sum;
  }
  // Sum of weights times the vertices' entries in v, of free unknowns; held ones do not move.
  template <class Weight>
  Eigen::Vector3d moved(const Eigen::Ref<const Eigen::VectorXd>& v, Weight&& weight) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < stencil_.count; ++i)
      for (int axis = 0; axis < 3; ++axis)
        if (const int at = unknown(i, axis); at >= 0) sum[axis] += weight(i) * v[at];
    return sum;
  }
  Eigen::Vector3d moved(const Eigen::Ref<const Eigen::VectorXd>& v) const {
    return moved(v, [&](int i) { return stencil_.shares[i].weight; });
  }
  int unknown(int share, int axis) const {
    return system_.position_index(stencil_.shares[share].rod, stencil_.shares[share].vertex, axis);
  }

  // The derivative of the force on the vertex of share i is weight force_rate + rates[i] force.
  struct ForceDerivative {
    Eigen::Vector3d force_rate = Eigen::Vector3d::Zero();
    std::array<double, 4> rates{};
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
  };
  ForceDerivative derivative(Kind kind) const {
    if (kind == Kind::stiffness) return {.force_rate = springs::force_by_stiffness(cable_, span_)};
    if (kind == Kind::rest_length)
      return {.force_rate = springs::force_by_rest_length(cable_, span_)};
    ForceDerivative result{.rates = rates(kind), .force = springs::force(cable_, span_)};
    result.force_rate =
        springs::stiffness_matrix(cable_, span_, springs::tension(cable_, span_.norm())) *
        span_rate(result.rates);
    return result;
  }

 private:
  const System& system_;
  const State& state_;
  const springs::Cable& cable_;
  const springs::Stencil& stencil_;
  Eigen::Vector3d span_;
};

// Adds the third derivative of the rods' energy along y and v.
void add_rods(const System& system, const State& state, const Eigen::VectorXd& y,
              const Eigen::Ref<const Eigen::VectorXd>& v, Eigen::Ref<Eigen::VectorXd> result) {
  for (int r = 0; r < static_cast<int>(state.size()); ++r) {
    const der::Rod& rod = system.structure().rods[r];
    const int count = der::unknowns(rod);
    Eigen::VectorXd own_y(count), own_v(count);
    for (int i = 0; i < count; ++i) {
      const int at = system.index(r, i);
      own_y[i] = at >= 0 ? y[at] : 0.0;
      own_v[i] = at >= 0 ? v[at] : 0.0;
    }
    const Eigen::VectorXd own = der::third_derivative(rod, state[r], own_y, own_v);
    for (int i = 0; i < count; ++i)
      if (const int at = system.index(r, i); at >= 0) result[at] += own[i];
  }
}

}  // namespace

Eigen::VectorXd values(std::span<const springs::Cable> cables,
                       std::span<const Parameter> parameters) {
  Eigen::VectorXd p(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    check(cables, parameters[j]);
    p[static_cast<Eigen::Index>(j)] = field(cables[parameters[j].cable], parameters[j].kind);
  }
  return p;
}

std::vector<springs::Cable> with_values(std::vector<springs::Cable> cables,
                                        std::span<const Parameter> parameters,
                                        const Eigen::VectorXd& p) {
  core::require(p.size() == static_cast<Eigen::Index>(parameters.size()),
                "with_values: needs a value for every parameter");
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    check(cables, parameters[j]);
    field(cables[parameters[j].cable], parameters[j].kind) = p[static_cast<Eigen::Index>(j)];
  }
  return cables;
}

ParameterJacobian force_derivatives(const System& system, const State& state,
                                    std::span<const Parameter> parameters) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(12 * parameters.size());
  for (int j = 0; j < static_cast<int>(parameters.size()); ++j) {
    check(system.structure().cables, parameters[j]);
    const CableAt at(system, state, parameters[j].cable);
    const auto derivative = at.derivative(parameters[j].kind);
    for (int i = 0; i < at.stencil().count; ++i) {
      const Eigen::Vector3d rate = at.stencil().shares[i].weight * derivative.force_rate +
                                   derivative.rates[i] * derivative.force;
      for (int axis = 0; axis < 3; ++axis)
        if (const int row = at.unknown(i, axis); row >= 0) entries.emplace_back(row, j, rate[axis]);
    }
  }
  ParameterJacobian result(system.size(), static_cast<Eigen::Index>(parameters.size()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Eigen::VectorXd force_derivatives_transposed(const System& system, const State& state,
                                             std::span<const Parameter> parameters,
                                             const Eigen::VectorXd& y) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    check(system.structure().cables, parameters[j]);
    const CableAt at(system, state, parameters[j].cable);
    const auto derivative = at.derivative(parameters[j].kind);
    result[static_cast<Eigen::Index>(j)] =
        derivative.force_rate.dot(at.moved(y)) +
        derivative.force.dot(at.moved(y, [&](int i) { return derivative.rates[i]; }));
  }
  return result;
}

ForceCurvature force_curvature(const System& system, const State& state,
                               std::span<const Parameter> parameters, const Eigen::VectorXd& y) {
  const int count = static_cast<int>(parameters.size());
  std::vector<std::vector<int>> parameters_of(system.stencils().size());
  for (int j = 0; j < count; ++j) {
    check(system.structure().cables, parameters[j]);
    parameters_of[parameters[j].cable].push_back(j);
  }
  std::vector<Eigen::Triplet<double>> mixed, own;
  for (int c = 0; c < static_cast<int>(parameters_of.size()); ++c) {
    const CableAt at(system, state, c);
    const Eigen::Vector3d span_y = at.moved(y);
    for (const int j : parameters_of[c]) {
      const Kind kind = parameters[j].kind;
      std::array<double, 4> rates{};
      springs::Variation along{.span_1 = span_y};
      if (kind == Kind::stiffness) {
        along.stiffness_2 = 1;
      } else if (kind == Kind::rest_length) {
        along.rest_length_2 = 1;
      } else {
        rates = at.rates(kind);
        along.span_2 = at.span_rate(rates);
        along.span_12 = at.moved(y, [&](int i) { return rates[i]; });
      }
      const springs::Response response = springs::respond(at.cable(), at.span(), along);
      for (int i = 0; i < at.stencil().count; ++i) {
        const Eigen::Vector3d rate =
            at.stencil().shares[i].weight * response.force_12 + rates[i] * response.force_1;
        for (int axis = 0; axis < 3; ++axis)
          if (const int row = at.unknown(i, axis); row >= 0) mixed.emplace_back(row, j, rate[axis]);
      }
      for (const int other : parameters_of[c]) {
        double value = 0;
        if (parameters[other].kind == Kind::stiffness) {
          value = response.by_stiffness_12;
        } else if (parameters[other].kind == Kind::rest_length) {
          value = response.by_rest_length_12;
        } else {
          const auto other_rates = at.rates(parameters[other].kind);
          value = response.force_12.dot(at.span_rate(other_rates)) +
                  response.force_2.dot(at.moved(y, [&](int i) { return other_rates[i]; }));
        }
        own.emplace_back(other, j, value);
      }
    }
  }
  ForceCurvature result{.mixed = ParameterJacobian(system.size(), count),
                        .parameters = ParameterJacobian(count, count)};
  result.mixed.setFromTriplets(mixed.begin(), mixed.end());
  result.parameters.setFromTriplets(own.begin(), own.end());
  return result;
}

Eigen::MatrixXd third_derivative_times(const System& system, const State& state,
                                       const Eigen::VectorXd& y,
                                       const Eigen::Ref<const Eigen::MatrixXd>& v) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(v.rows(), v.cols());
  for (Eigen::Index k = 0; k < v.cols(); ++k) add_rods(system, state, y, v.col(k), result.col(k));
  for (int c = 0; c < static_cast<int>(system.stencils().size()); ++c) {
    const CableAt at(system, state, c);
    Eigen::Matrix3d stiffness_rate;
    for (int axis = 0; axis < 3; ++axis)
      stiffness_rate.col(axis) =
          springs::respond(at.cable(), at.span(),
                           {.span_1 = at.moved(y), .span_2 = Eigen::Vector3d::Unit(axis)})
              .force_12;
    for (Eigen::Index k = 0; k < v.cols(); ++k) {
      const Eigen::Vector3d force = stiffness_rate * at.moved(v.col(k));
      for (int i = 0; i < at.stencil().count; ++i)
        for (int axis = 0; axis < 3; ++axis)
          if (const int row = at.unknown(i, axis); row >= 0)
            result(row, k) += at.stencil().shares[i].weight * force[axis];
    }
  }
  return result;
}

}  // namespace tencer::sensitivity
