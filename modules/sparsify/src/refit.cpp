#include "refit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <tencer/sensitivity/derivatives.hpp>

namespace tencer::sparsify {
namespace {

constexpr double largest_step = 0.5;  // of a variable

// A step of one (a stiffness gone, an attachment moved by an edge) costs a hundredth of the
// distance that is accepted: steps beyond the reach of the linear model do not pay.
constexpr double damping = 1e-2;

}  // namespace

Refitter::Refitter(const Network& network, const sensitivity::Target& target,
                   const RefineSetup& setup)
    : target_(target),
      variables_(design_variables(network, setup, 0.0)),
      root_unit_(std::sqrt(distance_scale(target, setup.percent))) {
  for (const auto& variable : variables_) parameters_.push_back(variable.parameter);
}

Refitter::Refit Refitter::at(const sensitivity::Configuration& configuration, int held) const {
  const auto& cables = configuration.cables();
  const auto size = static_cast<Eigen::Index>(variables_.size());
  // The optimizer's variables, roots of stiffnesses and arc lengths, and their rates.
  Eigen::VectorXd p = sensitivity::values(cables, parameters_);
  Eigen::VectorXd rates(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const Variable& variable = variables_[i];
    p[i] = (is_stiffness(variable) ? std::sqrt(p[i]) : p[i]) / variable.scale;
    rates[i] = is_stiffness(variable) ? 2 * p[i] * variable.scale * variable.scale : variable.scale;
  }
  const auto fit = sensitivity::least_squares(
      sensitivity::Distance(target_, configuration.system, configuration.state),
      sensitivity::state_derivatives(configuration, parameters_));
  const Eigen::VectorXd residual = fit.residual / root_unit_;
  Eigen::MatrixXd jacobian = fit.jacobian * rates.asDiagonal() / root_unit_;
  for (Eigen::Index i = 0; i < size; ++i)
    if (is_stiffness(variables_[i]) && parameters_[i].cable == held) jacobian.col(i).setZero();
  Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
  normal.diagonal().array() += damping;
  const Eigen::VectorXd slope = jacobian.transpose() * residual;
  const Eigen::VectorXd step = -normal.ldlt().solve(slope);

  Eigen::VectorXd values(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const Variable& variable = variables_[i];
    const double next = std::clamp(p[i] + std::clamp(step[i], -largest_step, largest_step),
                                   variable.lower, variable.upper) *
                        variable.scale;
    values[i] = is_stiffness(variable) ? next * next : next;
  }
  Refit result{.distance = residual.squaredNorm() + slope.dot(step),
               .cables = sensitivity::with_values(cables, parameters_, values)};
  result.cables[held].stiffness = cables[held].stiffness;
  return result;
}

}  // namespace tencer::sparsify
