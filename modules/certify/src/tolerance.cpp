#include <algorithm>
#include <cmath>
#include <random>
#include <tencer/certify/tolerance.hpp>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/constrained.hpp>
#include <tencer/equilibrium/modal.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <tencer/sensitivity/parameters.hpp>
#include <tencer/springs/derivatives.hpp>

namespace tencer::certify {
namespace {

using equilibrium::System;
using springs::Parameter;
using springs::ParameterKind;

// How fast the length that a cable's ends ask for grows with the parameter, the vertices held: one
// for its own length, less how fast its ends part as an attachment moves.
double length_rate(const System& system, const model::State& state, const Parameter& parameter) {
  if (parameter.kind == ParameterKind::rest_length) return 1;
  const springs::Stencil& stencil = system.stencils()[parameter.cable];
  const auto rates = springs::weight_rates(
      system.structure().cables[parameter.cable], stencil, system.arc_lengths(),
      parameter.kind == ParameterKind::position_a ? springs::Attachment::a
                                                  : springs::Attachment::b);
  Eigen::Vector3d parting = Eigen::Vector3d::Zero();
  for (int i = 0; i < stencil.count; ++i)
    parting += rates[i] * state[stencil.shares[i].rod].x.col(stencil.shares[i].vertex);
  return -parting.dot(model::span_of(stencil, state).normalized());
}

// With the vertices held, what each parameter does to the forces on them at constant tension
// (size x P; the negative of the gradient's change) and to the lengths (cables x P).
struct RightHandSides {
  Eigen::MatrixXd force{};
  Eigen::MatrixXd length{};
};
RightHandSides right_hand_sides(const System& system, const model::State& state,
                                const std::vector<Parameter>& parameters) {
  const auto count = static_cast<Eigen::Index>(parameters.size());
  RightHandSides result{
      .force = Eigen::MatrixXd::Zero(system.size(), count),
      .length = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(system.stencils().size()), count)};
  const auto jacobian = sensitivity::force_derivatives(system, state, parameters);
  const Eigen::MatrixXd gradients = equilibrium::length_gradients(system, state);
  for (Eigen::Index p = 0; p < count; ++p) {
    const Parameter& parameter = parameters[p];
    const int c = parameter.cable;
    const double rate = length_rate(system, state, parameter);
    result.length(c, p) = rate;
    if (parameter.kind == ParameterKind::rest_length) continue;
    // The springs' forces change with their lengths too, which those of taut cables do not.
    result.force.col(p) = -Eigen::VectorXd(jacobian.col(p)) -
                          system.structure().cables[c].stiffness * rate * gradients.col(c);
  }
  return result;
}

}  // namespace

PoseResponse pose_response(const model::Structure& structure, const model::State& state,
                           const Eigen::VectorXd& tensions, const std::vector<model::View>& views) {
  const std::vector<int> taut = equilibrium::taut_cables(tensions);
  const System system = equilibrium::taut_system(structure, state, tensions, taut);
  PoseResponse result;
  for (int c = 0; c < static_cast<int>(taut.size()); ++c)
    for (const Parameter& parameter : parameters_of(system.structure().cables[c], c))
      result.parameters.push_back(parameter);
  equilibrium::ConstrainedHessian hessian(system, state,
                                          equilibrium::length_gradients(system, state),
                                          equilibrium::lumped_mass(system));
  if (!hessian.factorise()) return result;
  const auto [force, length] = right_hand_sides(system, state, result.parameters);
  const auto [motion, tension] = hessian.respond(force, length);
  model::Target target = model::make_target(structure, model::positions_of(state));
  target.views = views;
  result.displacement = sensitivity::Distance(target, system, state).residual_rates(motion);
  result.tension = Eigen::MatrixXd::Zero(tensions.size(), tension.cols());
  for (std::size_t c = 0; c < taut.size(); ++c)
    result.tension.row(taut[c]) = tension.row(static_cast<Eigen::Index>(c));
  for (Parameter& parameter : result.parameters) parameter.cable = taut[parameter.cable];
  result.computed = result.displacement.allFinite() && result.tension.allFinite();
  return result;
}

std::vector<Parameter> parameters_of(const springs::Cable& cable, int c) {
  std::vector<Parameter> parameters{{ParameterKind::rest_length, c}};
  if (std::holds_alternative<springs::OnRod>(cable.a))
    parameters.push_back({ParameterKind::position_a, c});
  if (std::holds_alternative<springs::OnRod>(cable.b))
    parameters.push_back({ParameterKind::position_b, c});
  return parameters;
}

double limit_of(const CableErrors& errors, const Parameter& parameter) {
  return parameter.kind == ParameterKind::rest_length ? errors.length : errors.attachment;
}

Eigen::MatrixXd unit_draws(int parameters, int draws, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  // The library's distributions differ from one standard library to the next.
  return Eigen::MatrixXd::NullaryExpr(
      parameters, draws, [&] { return std::ldexp(static_cast<double>(engine() >> 11), -52) - 1; });
}

double typical_deviation(const PoseResponse& response, const CableErrors& errors) {
  core::require(response.computed, "typical_deviation: needs a response");
  // A uniform error up to e has the mean square e^2 / 3.
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(response.displacement.rows() / 3);
  for (std::size_t p = 0; p < response.parameters.size(); ++p) {
    const double limit = limit_of(errors, response.parameters[p]);
    squares += limit * limit / 3 *
               response.displacement.col(static_cast<Eigen::Index>(p))
                   .reshaped(3, squares.size())
                   .colwise()
                   .squaredNorm()
                   .transpose();
  }
  return std::sqrt(squares.maxCoeff());
}

Tolerance tolerance(const PoseResponse& response, const Eigen::VectorXd& tensions,
                    const CableErrors& errors, int draws, std::uint64_t seed) {
  core::require(response.computed, "tolerance: needs a response");
  core::require(errors.length >= 0 && errors.attachment >= 0 && std::isfinite(errors.length) &&
                    std::isfinite(errors.attachment),
                "tolerance: errors must not be negative");
  core::require(draws >= 1, "tolerance: needs draws >= 1");
  const auto count = static_cast<Eigen::Index>(response.parameters.size());
  Tolerance result;
  if (count == 0) return result;
  Eigen::VectorXd limits(count);
  for (Eigen::Index p = 0; p < count; ++p) limits[p] = limit_of(errors, response.parameters[p]);
  const Eigen::MatrixXd moved = response.displacement * limits.asDiagonal();
  const Eigen::Index vertices = moved.rows() / 3;

  const Eigen::MatrixXd samples = unit_draws(static_cast<int>(count), draws, seed);
  std::vector<double> deviations;
  constexpr Eigen::Index batch = 256;
  for (Eigen::Index first = 0; first < draws; first += batch) {
    const Eigen::MatrixXd x = moved * samples.middleCols(first, std::min(batch, draws - first));
    for (const auto& draw : x.colwise())
      deviations.push_back(draw.reshaped(3, vertices).colwise().norm().maxCoeff());
  }
  std::ranges::sort(deviations);
  double sum = 0;
  for (const double deviation : deviations) sum += deviation;
  result.expected = sum / draws;
  result.percentile_95 = deviations[static_cast<std::size_t>(std::ceil(0.95 * draws)) - 1];
  result.worst = deviations.back();

  // A uniform error up to e has the mean square e^2 / 3.
  Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(vertices, tensions.size());
  for (Eigen::Index p = 0; p < count; ++p)
    squares.col(response.parameters[p].cable) +=
        moved.col(p).reshaped(3, vertices).colwise().squaredNorm().transpose() / 3;
  const Eigen::VectorXd own = squares.colwise().maxCoeff().cwiseSqrt();
  if (own.maxCoeff(&result.decisive_cable) > 0)
    result.decisive = own[result.decisive_cable];
  else
    result.decisive_cable = -1;

  const Eigen::VectorXd loss = response.tension.cwiseAbs() * limits;
  for (int c = 0; c < loss.size(); ++c)
    if (loss[c] > 0)
      if (const double at = tensions[c] / loss[c]; result.first_slack < 0 || at < result.slack_at) {
        result.first_slack = c;
        result.slack_at = at;
      }
  return result;
}

}  // namespace tencer::certify
