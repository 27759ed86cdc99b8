#include "state/fitted_network.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tencer/network/rest_length.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <tencer/springs/law.hpp>
#include <utility>

#include "model/gap_bounds.hpp"
#include "model/soft_rates.hpp"

namespace tencer::elimination {
namespace {

constexpr double clearly_stiffer = 10;  // than the least eigenvalue: no need to factorise again

double edge_of(const model::Structure& structure, int rod) {
  return structure.rods[rod].rest_lengths.mean();
}

}  // namespace

FittedNetwork::FittedNetwork(const network::Network& network, const Requirements& requirements,
                             const Objective& objective, const StepOptions& options,
                             const network::Control& control)
    : requirements_(requirements),
      objective_(objective),
      options_(options),
      control_(control),
      at_{.system = equilibrium::System(network.structure)},
      trial_{.system = equilibrium::System(network.structure)},
      damping_(options.damping) {
  restart(network);
}

bool FittedNetwork::restart(const network::Network& network) {
  trial_.system.set_cables(network.structure.cables);
  errors_.deviation = std::numeric_limits<double>::infinity();  // the network is as it is
  usable_ = solve_trial(
      network.state, {},
      {.tolerance = options_.tolerance, .max_turn = options_.max_turn, .stop = control_.stop});
  if (usable_) accept();
  return usable_;
}

void FittedNetwork::set(const Objective& objective) {
  objective_ = objective;
  const sensitivity::Distance distance(requirements_.target, at_.system, at_.state);
  value_ = evaluate(distance.residual(), soft_, errors_);
}

FittedNetwork::Softness FittedNetwork::softness(double eigenvalue, double variance) const {
  const double soft = 10 * requirements_.min_eigenvalue / eigenvalue;
  const double moved = 4 * variance / std::pow(requirements_.workmanship.max_deviation, 2);
  // The forces of the errors on the mode stay nearly the same, so that the variance goes with the
  // inverse square of the eigenvalue.
  return {.value = soft + moved, .rate = -(soft + 2 * moved) / eigenvalue};
}

double FittedNetwork::evaluate(const Eigen::VectorXd& residual, const equilibrium::SoftModes& soft,
                               const ErrorResponse& errors) const {
  double sum = 0;
  for (Eigen::Index k = 0; k < soft.values.size(); ++k)
    sum += softness(soft.values[k], errors.covariance(k, k)).value;
  return mismatch(residual, objective_.norm) + objective_.stability_weight * sum;
}

// Solves for the trial's equilibrium and judges it.
bool FittedNetwork::solve_trial(model::State start, const equilibrium::SoftModes& nearby,
                                const equilibrium::SolveOptions& options) {
  trial_.linearisation.matrix = trial_.system.pattern();
  auto solved = equilibrium::solve(trial_.system, std::move(start), options, trial_.linearisation);
  counts_ += {.solves = 1, .iterations = solved.iterations};
  if (!solved.usable()) return false;
  trial_.state = std::move(solved.state);
  if (!trial_is_valid()) return false;
  trial_soft_ = equilibrium::soft_modes(trial_.system, trial_.linearisation, nearby);
  const double softest = trial_soft_.values[0];
  const double limit = requirements_.min_eigenvalue;
  if (!(softest > limit)) return false;
  if (softest < clearly_stiffer * limit &&
      !equilibrium::stiffer_than(trial_.system, trial_.linearisation, limit, workspace_))
    return false;
  trial_errors_ =
      error_response(trial_, trial_soft_, requirements_.workmanship, requirements_.fixed_cables,
                     model::seen_metric(sensitivity::views_at(requirements_.target, trial_.state)));
  if (2 * trial_errors_.deviation > requirements_.workmanship.max_deviation &&
      trial_errors_.deviation > errors_.deviation)
    return false;
  const sensitivity::Distance distance(requirements_.target, trial_.system, trial_.state);
  trial_deviation_ = distance.deviation();
  trial_value_ = evaluate(distance.residual(), trial_soft_, trial_errors_);
  return std::isfinite(trial_value_);
}

// Whether the trial is stable, its rods no more free of each other than allowed, and its cables
// pull and are short enough.
bool FittedNetwork::trial_is_valid() const {
  const auto& at = trial_.linearisation;
  if (!at.regular || at.negative > 0) return false;
  if (equilibrium::floating_components(at.rigid) > requirements_.max_floating) return false;
  for (std::size_t c = 0; c < trial_.cables().size(); ++c) {
    const double length = model::span_of(trial_.system.stencils()[c], trial_.state).norm();
    if (!(springs::tension(trial_.cables()[c], length) > 0)) return false;
    if (length > requirements_.rules.max_cable_length * (1 + 1e-9)) return false;
  }
  const model::Rules& rules = requirements_.rules;
  return rules.unwanted.empty() ||
         std::ranges::none_of(trial_.cables(), [&](const springs::Cable& cable) {
           return model::is_unwanted(rules, trial_.system.arc_lengths(), cable);
         });
}

void FittedNetwork::accept() {
  std::swap(at_, trial_);
  soft_ = trial_soft_;
  errors_ = trial_errors_;
  deviation_ = trial_deviation_;
  value_ = trial_value_;
}

Squares FittedNetwork::stability_terms(const LocalModel& local,
                                       const sensitivity::Configuration& at,
                                       const equilibrium::SoftModes& soft,
                                       const ErrorResponse& errors) const {
  if (!(objective_.stability_weight > 0))
    return {.value = {}, .rates = Eigen::MatrixXd(0, local.ties.cols())};
  const Eigen::Index modes = soft.values.size();
  Squares terms{.value = Eigen::VectorXd(modes),
                .rates = Eigen::MatrixXd(modes, local.ties.cols())};
  for (Eigen::Index k = 0; k < modes; ++k) {
    const Eigen::VectorXd rate = soft_rates(at, soft, k, local);
    const auto [value, slope] = softness(soft.values[k], errors.covariance(k, k));
    terms.value[k] = std::sqrt(objective_.stability_weight * value);
    terms.rates.row(k) = terms.value[k] * slope / (2 * value) * rate.transpose();
  }
  return terms;
}

StepBounds FittedNetwork::step_bounds(const LocalModel& local) const {
  const auto& structure = at_.system.structure();
  const model::Rules& rules = requirements_.rules;
  const auto orbits = static_cast<Eigen::Index>(local.orbits.size());
  const auto slides = static_cast<Eigen::Index>(local.positions.size());
  const bool limited = std::isfinite(rules.max_cable_length);
  const StepBounds gaps = objective_.buildable && rules.gaps
                              ? gap_bounds(at_, local, *rules.gaps)
                              : StepBounds{.rows = Eigen::MatrixXd(0, local.ties.cols())};
  const Eigen::Index rows = orbits + 2 * slides + (limited ? orbits : 0) + gaps.lower.size();
  StepBounds bounds{.rows = Eigen::MatrixXd::Zero(rows, local.ties.cols()),
                    .lower = Eigen::VectorXd(rows)};
  bounds.rows.topRows(orbits) = local.density_rates;
  bounds.lower.head(orbits) = (options_.kept_density - 1) * local.density;
  if (objective_.buildable && orbits > 0) {
    const double least = requirements_.workmanship.least_tension(
        local.density.cwiseProduct(local.length).maxCoeff());
    bounds.lower.head(orbits) =
        bounds.lower.head(orbits).cwiseMax(least * local.length.cwiseInverse() - local.density);
  }
  Eigen::Index row = orbits;
  for (const auto& position : local.positions) {
    const double most = options_.max_slide * edge_of(structure, position.at.rod);
    const model::Interval free = sliding_interval(rules, structure, position.at.rod, position.at.s);
    bounds.rows(row, position.variable) = 1;
    bounds.lower[row++] = std::max(free.lower - position.at.s, -most);
    bounds.rows(row, position.variable) = -1;
    bounds.lower[row++] = -std::min(free.upper - position.at.s, most);
  }
  if (limited) {
    bounds.rows.middleRows(row, orbits) = -local.length_rates;
    bounds.lower.segment(row, orbits) = local.length.array() - rules.max_cable_length;
  }
  bounds.rows.bottomRows(gaps.lower.size()) = gaps.rows;
  bounds.lower.tail(gaps.lower.size()) = gaps.lower;
  return bounds;
}

GaussNewtonModel FittedNetwork::gauss_newton_model(double damping_factor) const {
  return model_at(at_, soft_, errors_, damping_factor);
}

GaussNewtonModel FittedNetwork::trial_model() const {
  return model_at(trial_, trial_soft_, trial_errors_, 1.0);
}

GaussNewtonModel FittedNetwork::model_at(const sensitivity::Configuration& at,
                                         const equilibrium::SoftModes& soft,
                                         const ErrorResponse& errors, double damping_factor) const {
  const auto& structure = at.system.structure();
  LocalModel local =
      local_model(at, requirements_.target, requirements_.symmetry, requirements_.fixed_cables);
  double edge = std::numeric_limits<double>::infinity();
  for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r)
    edge = std::min(edge, edge_of(structure, r));
  const double cost = damping_factor * damping_;
  Eigen::VectorXd damping = Eigen::VectorXd::Constant(local.ties.cols(), cost / (edge * edge));
  for (const auto& position : local.positions)
    damping[position.variable] = cost / std::pow(edge_of(structure, position.at.rod), 2);
  const Squares stability = stability_terms(local, at, soft, errors);
  StepBounds bounds = step_bounds(local);
  return {std::move(local), objective_.norm, stability, damping, std::move(bounds)};
}

Eigen::VectorXd FittedNetwork::removal_instability(const LocalModel& local) const {
  const Eigen::VectorXd mass = equilibrium::lumped_mass(at_.system);
  const double scale = objective_.stability_weight * 10 * requirements_.min_eigenvalue *
                       equilibrium::eigenvalue_unit(at_.system.structure());
  Eigen::VectorXd result(static_cast<Eigen::Index>(local.orbits.size()));
  for (Eigen::Index o = 0; o < result.size(); ++o) {
    // H^-1 changes by a matrix of rank 1 when the cable's stiffness along itself goes; a negative
    // denominator is a lost eigenvalue. The tied cables of an orbit move together.
    const Eigen::VectorXd motion = local.motion.col(local.rest_lengths[o]);
    const double left = at_.cables()[local.orbits[o].front()].stiffness *
                        (1 - local.length_rates(o, local.rest_lengths[o]));
    result[o] = left > 0 ? scale * motion.dot(mass.cwiseProduct(motion)) / left
                         : std::numeric_limits<double>::infinity();
  }
  return result;
}

bool FittedNetwork::move(const LocalModel& local, const Eigen::VectorXd& step,
                         const std::vector<int>& out, double max_value) {
  constexpr double rest_ratio = network::stiff_rest_ratio;
  const auto& system = at_.system;
  const Eigen::VectorXd motion = local.motion * step;
  // Next to a loss of stability steps or what they move have no bounds.
  if (!step.allFinite() || !std::isfinite(motion.squaredNorm())) return false;
  model::State predicted = system.displaced(at_.state, motion);
  auto cables = at_.cables();
  const Eigen::VectorXd change = local.ties * step;
  for (Eigen::Index i = 0; i < change.size(); ++i) {
    const auto [kind, c] = local.parameters[i];
    if (kind == springs::ParameterKind::rest_length) continue;
    auto& end = kind == springs::ParameterKind::position_a ? cables[c].a : cables[c].b;
    std::get<springs::OnRod>(end).s += change[i];
  }
  const Eigen::VectorXd density = (local.density + local.density_rates * step)
                                      .cwiseMax(options_.kept_density / 2 * local.density);
  if (!density.allFinite()) return false;
  for (std::size_t o = 0; o < local.orbits.size(); ++o)
    for (const int c : local.orbits[o]) {
      const auto stencil =
          springs::stencil(cables[c], system.arc_lengths(), system.structure().anchors);
      cables[c].rest_length = rest_ratio * model::span_of(stencil, predicted).norm();
      cables[c].stiffness = density[static_cast<Eigen::Index>(o)] / (1 - rest_ratio);
    }
  std::vector<bool> gone(cables.size(), false);
  for (const int o : out)
    for (const int c : local.orbits[o]) gone[c] = true;
  std::vector<springs::Cable> left;
  for (std::size_t c = 0; c < cables.size(); ++c)
    if (!gone[c]) left.push_back(cables[c]);
  trial_.system.set_cables(std::move(left));
  auto forces = equilibrium::predicted_forces(system, at_.state, motion);
  // Fixed cables have the tension that is predicted, others the one that they were given.
  const Eigen::VectorXd fixed = forces.tension.head(requirements_.fixed_cables);
  forces.tension = trial_.system.internal_forces(predicted).tension;
  forces.tension.head(requirements_.fixed_cables) = fixed;
  const bool solved = solve_trial(std::move(predicted), soft_,
                                  {.tolerance = options_.tolerance,
                                   .max_turn = options_.max_turn,
                                   .max_iterations = options_.max_iterations,
                                   .max_path_rotation = options_.max_path_rotation,
                                   .forces = std::move(forces),
                                   .stop = control_.stop});
  if (!solved || !(trial_value_ < max_value)) return false;
  accept();
  return true;
}

std::optional<double> FittedNetwork::evaluate(std::vector<springs::Cable> cables,
                                              model::State predicted) {
  constexpr int patience = 4;  // times the steps and turns of small changes
  trial_.system.set_cables(std::move(cables));
  const bool solved = solve_trial(std::move(predicted), soft_,
                                  {.tolerance = options_.tolerance,
                                   .max_turn = options_.max_turn,
                                   .max_iterations = patience * options_.max_iterations,
                                   .max_path_rotation = patience * options_.max_path_rotation,
                                   .stop = control_.stop});
  return solved ? std::optional(trial_value_) : std::nullopt;
}

void FittedNetwork::refit(int steps, double min_gain) {
  for (int k = 0; k < steps && cables() > 0 && !stopped(); ++k) {
    const double before = value_;
    bool moved = false;
    for (int attempt = 0; attempt < options_.attempts && !moved; ++attempt) {
      const GaussNewtonModel model = gauss_newton_model();
      moved = move(model.local(), model.step({}, std::pow(0.5, attempt)), {}, value_);
      damping_ = std::clamp(moved ? damping_ / 4 : 8 * damping_, options_.min_damping,
                            options_.max_damping);
    }
    if (!moved || value_ > (1 - min_gain) * before) return;
  }
}

}  // namespace tencer::elimination
