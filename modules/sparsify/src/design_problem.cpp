#include "design_problem.hpp"

#include <cmath>
#include <tencer/equilibrium/modal.hpp>
#include <utility>

#include "homotopy.hpp"

namespace tencer::sparsify {
namespace {

std::vector<springs::Parameter> parameters_of(const std::vector<Variable>& variables) {
  std::vector<springs::Parameter> parameters;
  for (const auto& variable : variables) parameters.push_back(variable.parameter);
  return parameters;
}

}  // namespace

DesignProblem::DesignProblem(const network::Network& network, const model::Target& target,
                             DesignSetup setup, const network::Control& control)
    : target_(target),
      setup_(std::move(setup)),
      parameters_(parameters_of(setup_.variables)),
      cables_(network.structure.cables),
      tracker_(network.structure, network.state, follow_options(control)),
      start_(sensitivity::values(cables_, parameters_)) {
  for (Eigen::Index i = 0; i < start_.size(); ++i) {
    const Variable& variable = setup_.variables[i];
    start_[i] = (is_stiffness(variable) ? std::sqrt(start_[i]) : start_[i]) / variable.scale;
  }
  counts_ += {.solves = 1, .iterations = tracker_.first().iterations};
}

Eigen::VectorXd DesignProblem::parameter_values(const Eigen::VectorXd& p) const {
  Eigen::VectorXd v = p;
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    const Variable& variable = setup_.variables[i];
    v[i] *= variable.scale;
    if (is_stiffness(variable)) v[i] *= v[i];
  }
  return v;
}

Eigen::VectorXd DesignProblem::rates(const Eigen::VectorXd& p) const {
  Eigen::VectorXd rates(p.size());
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    const Variable& variable = setup_.variables[i];
    rates[i] = is_stiffness(variable) ? 2 * p[i] * variable.scale * variable.scale : variable.scale;
  }
  return rates;
}

Eigen::VectorXd DesignProblem::rate_changes() const {
  Eigen::VectorXd changes(static_cast<Eigen::Index>(setup_.variables.size()));
  for (Eigen::Index i = 0; i < changes.size(); ++i) {
    const Variable& variable = setup_.variables[i];
    changes[i] = is_stiffness(variable) ? 2 * variable.scale * variable.scale : 0.0;
  }
  return changes;
}

bool DesignProblem::evaluate(const Eigen::VectorXd& p) {
  if (last_.size() == p.size() && last_ == p) return distance_.has_value();
  last_ = p;
  distance_.reset();
  const auto cables = sensitivity::with_values(cables_, parameters_, parameter_values(p));
  const auto& from = tracker_.committed();
  if (!holds_as_before({from.system.structure(), from.state}, cables)) return false;
  const auto trial = tracker_.evaluate(cables);
  counts_ += {.solves = trial.solves, .iterations = trial.equilibrium.iterations};
  if (!trial.usable()) return false;
  const auto& at = tracker_.trial();
  if (!at.linearisation.regular ||
      !equilibrium::stiffer_than(at.system, at.linearisation, setup_.min_eigenvalue, workspace_))
    return false;
  const network::Network network{at.system.structure(), at.state};
  if (cable_lengths(network).maxCoeff() > setup_.max_cable_length * (1 + 1e-9)) return false;
  if (setup_.all_pull && !idle_cables(network).empty()) return false;
  distance_.emplace(target_, at.system, at.state);
  return true;
}

std::optional<double> DesignProblem::value(const Eigen::VectorXd& p) {
  if (!evaluate(p)) return std::nullopt;
  double value = distance_->deviation().value / setup_.distance_scale;
  for (Eigen::Index i = 0; i < p.size(); ++i) value += setup_.variables[i].sparsity * p[i];
  if (value < best_value_) {
    best_value_ = value;
    best_ = network::Network{tracker_.trial().system.structure(), tracker_.trial().state};
  }
  return value;
}

bool DesignProblem::gradient(const Eigen::VectorXd& p, Eigen::VectorXd& g) {
  if (!evaluate(p)) return false;
  const auto& at = tracker_.trial();
  g = sensitivity::gradient(at, parameters_, sensitivity::adjoint(at, *distance_));
  g = g.cwiseProduct(rates(p)) / setup_.distance_scale;
  for (Eigen::Index i = 0; i < p.size(); ++i) g[i] += setup_.variables[i].sparsity;
  return g.allFinite();
}

bool DesignProblem::hessian(const Eigen::VectorXd& p, Eigen::MatrixXd& h) {
  if (!evaluate(p)) return false;
  const auto& at = tracker_.trial();
  const Eigen::MatrixXd moves = sensitivity::state_derivatives(at, parameters_);
  const Eigen::VectorXd adjoint = sensitivity::adjoint(at, *distance_);
  h = setup_.exact ? sensitivity::hessian(at, parameters_, *distance_, adjoint, moves)
                   : sensitivity::least_squares(*distance_, moves).gauss_newton();
  const Eigen::VectorXd rate = rates(p);
  h = rate.asDiagonal() * h * rate.asDiagonal();
  h.diagonal() += sensitivity::gradient(at, parameters_, adjoint).cwiseProduct(rate_changes());
  h /= setup_.distance_scale;
  return h.allFinite();
}

optimize::Problem DesignProblem::problem() {
  optimize::Problem problem;
  problem.lower.resize(start_.size());
  problem.upper.resize(start_.size());
  for (Eigen::Index i = 0; i < start_.size(); ++i) {
    problem.lower[i] = setup_.variables[i].lower;
    problem.upper[i] = setup_.variables[i].upper;
  }
  problem.value = [this](const Eigen::VectorXd& p) { return value(p); };
  problem.gradient = [this](const Eigen::VectorXd& p, Eigen::VectorXd& g) {
    return gradient(p, g);
  };
  problem.hessian = [this](const Eigen::VectorXd& p, Eigen::MatrixXd& h) { return hessian(p, h); };
  return problem;
}

void DesignProblem::move_to(const Eigen::VectorXd& p) {
  if (!evaluate(p)) return;
  tracker_.commit();
  last_.resize(0);
  distance_.reset();
}

}  // namespace tencer::sparsify
