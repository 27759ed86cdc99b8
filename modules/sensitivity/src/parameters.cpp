#include <tencer/core/error.hpp>
#include <tencer/sensitivity/parameters.hpp>

#include "cable_at.hpp"

namespace tencer::sensitivity {
namespace {

using equilibrium::System;
using model::State;

// The field of a cable that a parameter stands for.
template <class Cable>
auto& field(Cable& cable, springs::ParameterKind kind) {
  switch (kind) {
    case springs::ParameterKind::stiffness:
      return cable.stiffness;
    case springs::ParameterKind::rest_length:
      return cable.rest_length;
    case springs::ParameterKind::position_a:
    case springs::ParameterKind::position_b:
      break;
  }
  auto* on_rod =
      std::get_if<springs::OnRod>(kind == springs::ParameterKind::position_a ? &cable.a : &cable.b);
  core::require(on_rod != nullptr, "parameter: an anchored end has no position on a rod");
  return on_rod->s;
}

void check(std::span<const springs::Cable> cables, const springs::Parameter& parameter) {
  core::require(parameter.cable >= 0 && parameter.cable < static_cast<int>(cables.size()),
                "parameter: no such cable");
}

}  // namespace

Eigen::VectorXd values(std::span<const springs::Cable> cables,
                       std::span<const springs::Parameter> parameters) {
  Eigen::VectorXd p(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    check(cables, parameters[j]);
    p[static_cast<Eigen::Index>(j)] = field(cables[parameters[j].cable], parameters[j].kind);
  }
  return p;
}

std::vector<springs::Cable> with_values(std::vector<springs::Cable> cables,
                                        std::span<const springs::Parameter> parameters,
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
                                    std::span<const springs::Parameter> parameters) {
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
                                             std::span<const springs::Parameter> parameters,
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
                               std::span<const springs::Parameter> parameters,
                               const Eigen::VectorXd& y) {
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
      const springs::ParameterKind kind = parameters[j].kind;
      std::array<double, 4> rates{};
      springs::Variation along{.span_1 = span_y};
      if (kind == springs::ParameterKind::stiffness) {
        along.stiffness_2 = 1;
      } else if (kind == springs::ParameterKind::rest_length) {
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
        if (parameters[other].kind == springs::ParameterKind::stiffness) {
          value = response.by_stiffness_12;
        } else if (parameters[other].kind == springs::ParameterKind::rest_length) {
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

}  // namespace tencer::sensitivity
