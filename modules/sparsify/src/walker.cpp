#include "walker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tencer/springs/law.hpp>
#include <utility>

#include "stiffness_floor.hpp"

namespace tencer::sparsify {
namespace {

// What a variable's change by an edge costs, in units of the objective; refit() adapts it.
constexpr double least_damping = 3e-4;
constexpr double most_damping = 1e3;
constexpr double longest_slide = 4.0;   // edges in a step
constexpr double kept_density = 0.2;    // part of a force density that a step leaves
constexpr double clearly_stiffer = 10;  // than the least eigenvalue: no need to factorise again
constexpr double tolerance = 1e-9;      // of equilibria on the way
constexpr int most_iterations = 12;     // good steps take 3 to 8
constexpr double farthest = 0.3;        // and seldom turn an edge by as much, in radians

double edge_of(const equilibrium::Structure& structure, int rod) {
  return structure.rods[rod].rest_lengths.mean();
}

}  // namespace

Walker::Walker(const Network& network, const Task& task, const Drive& drive, const Control& control)
    : task_(task),
      drive_(drive),
      control_(control),
      at_{.system = equilibrium::System(network.structure)},
      trial_{.system = equilibrium::System(network.structure)} {
  restart(network);
}

bool Walker::restart(const Network& network) {
  trial_.system.set_cables(network.structure.cables);
  usable_ = settle(network.state, {}, {.tolerance = tolerance, .stop = control_.stop});
  if (usable_) accept();
  return usable_;
}

void Walker::set(const Drive& drive) {
  drive_ = drive;
  const sensitivity::Distance distance(task_.target, at_.system, at_.state);
  value_ = objective(distance.residual(), soft_);
}

double Walker::objective(const Eigen::VectorXd& residual, const SoftModes& soft) const {
  return mismatch(residual, drive_.aim) +
         drive_.softness * 10 * task_.least_eigenvalue * soft.values.cwiseInverse().sum();
}

// Solves for the trial's equilibrium and judges it.
bool Walker::settle(equilibrium::State start, const SoftModes& nearby,
                    const equilibrium::SolveOptions& options) {
  trial_.linearisation.matrix = trial_.system.pattern();
  auto solved = equilibrium::solve(trial_.system, std::move(start), options, trial_.linearisation);
  ++solves_;
  iterations_ += solved.iterations;
  if (!solved.usable()) return false;
  trial_.state = std::move(solved.state);
  if (!trial_.linearisation.regular || trial_.linearisation.negative > 0) return false;
  if (equilibrium::free_groups(trial_.linearisation.rigid) > task_.groups) return false;
  for (std::size_t c = 0; c < trial_.cables().size(); ++c) {
    const double length = equilibrium::span_of(trial_.system.stencils()[c], trial_.state).norm();
    if (!(springs::tension(trial_.cables()[c], length) > 0)) return false;
    if (length > task_.rules.longest * (1 + 1e-9)) return false;
  }
  trial_soft_ = soft_modes(trial_, nearby);
  const double softest = trial_soft_.values[0];
  if (!(softest > task_.least_eigenvalue)) return false;
  if (softest < clearly_stiffer * task_.least_eigenvalue &&
      !stiffer_than(trial_, task_.least_eigenvalue, workspace_))
    return false;
  const sensitivity::Distance distance(task_.target, trial_.system, trial_.state);
  trial_deviation_ = distance.deviation();
  trial_value_ = objective(distance.residual(), trial_soft_);
  return std::isfinite(trial_value_);
}

void Walker::accept() {
  std::swap(at_, trial_);
  soft_ = trial_soft_;
  deviation_ = trial_deviation_;
  value_ = trial_value_;
}

Squares Walker::softness_terms(const LocalModel& model) const {
  if (!(drive_.softness > 0)) return {.value = {}, .rates = Eigen::MatrixXd(0, model.ties.cols())};
  const Eigen::Index modes = soft_.values.size();
  Squares terms{.value = Eigen::VectorXd(modes),
                .rates = Eigen::MatrixXd(modes, model.ties.cols())};
  for (Eigen::Index k = 0; k < modes; ++k) {
    const Eigen::VectorXd rate =
        soft_rates(at_, soft_, k, model.parameters, model.ties, model.motion);
    terms.value[k] = std::sqrt(drive_.softness * 10 * task_.least_eigenvalue / soft_.values[k]);
    terms.rates.row(k) = -terms.value[k] / (2 * soft_.values[k]) * rate.transpose();
  }
  return terms;
}

StepBounds Walker::step_bounds(const LocalModel& model) const {
  const auto& structure = at_.system.structure();
  const auto orbits = static_cast<Eigen::Index>(model.orbits.size());
  const auto slides = static_cast<Eigen::Index>(model.positions.size());
  const bool limited = std::isfinite(task_.rules.longest);
  const Eigen::Index rows = orbits + 2 * slides + (limited ? orbits : 0);
  StepBounds bounds{.rows = Eigen::MatrixXd::Zero(rows, model.ties.cols()),
                    .least = Eigen::VectorXd(rows)};
  bounds.rows.topRows(orbits) = model.density_rates;
  bounds.least.head(orbits) = (kept_density - 1) * model.density;
  Eigen::Index row = orbits;
  for (const auto& position : model.positions) {
    const double most = longest_slide * edge_of(structure, position.at.rod);
    const Interval free = sliding_interval(task_.rules, structure, position.at.rod, position.at.s);
    bounds.rows(row, position.variable) = 1;
    bounds.least[row++] = std::max(free.lower - position.at.s, -most);
    bounds.rows(row, position.variable) = -1;
    bounds.least[row++] = -std::min(free.upper - position.at.s, most);
  }
  if (limited) {
    bounds.rows.bottomRows(orbits) = -model.length_rates;
    bounds.least.tail(orbits) = model.length.array() - task_.rules.longest;
  }
  return bounds;
}

Planner Walker::planner(double care) const {
  const auto& structure = at_.system.structure();
  LocalModel model = local_model(at_, task_.target, task_.symmetry, task_.kept);
  double edge = std::numeric_limits<double>::infinity();
  for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r)
    edge = std::min(edge, edge_of(structure, r));
  Eigen::VectorXd damping =
      Eigen::VectorXd::Constant(model.ties.cols(), care * damping_ / (edge * edge));
  for (const auto& position : model.positions)
    damping[position.variable] = care * damping_ / std::pow(edge_of(structure, position.at.rod), 2);
  const Squares soft = softness_terms(model);
  StepBounds bounds = step_bounds(model);
  return {std::move(model), drive_.aim, soft, damping, std::move(bounds)};
}

Eigen::VectorXd Walker::removal_softness(const LocalModel& model) const {
  const Eigen::VectorXd mass = lumped_mass(at_.system);
  const double scale = drive_.softness * 10 * task_.least_eigenvalue * eigenvalue_unit(at_.system);
  Eigen::VectorXd result(static_cast<Eigen::Index>(model.orbits.size()));
  for (Eigen::Index o = 0; o < result.size(); ++o) {
    // H^-1 changes by a matrix of rank 1 when the cable's stiffness along itself goes; a negative
    // denominator is a lost eigenvalue. The tied cables of an orbit move together.
    const Eigen::VectorXd motion = model.motion.col(model.rest_lengths[o]);
    const double left = at_.cables()[model.orbits[o].front()].stiffness *
                        (1 - model.length_rates(o, model.rest_lengths[o]));
    result[o] = left > 0 ? scale * motion.dot(mass.cwiseProduct(motion)) / left
                         : std::numeric_limits<double>::infinity();
  }
  return result;
}

bool Walker::move(const LocalModel& model, const Eigen::VectorXd& step, const std::vector<int>& out,
                  double accepted) {
  if (!step.allFinite()) return false;
  const auto& system = at_.system;
  const Eigen::VectorXd change = model.ties * step;
  auto cables = at_.cables();
  for (Eigen::Index i = 0; i < change.size(); ++i) {
    const auto [kind, c] = model.parameters[i];
    if (kind == sensitivity::Kind::rest_length) continue;
    std::get<springs::OnRod>(kind == sensitivity::Kind::position_a ? cables[c].a : cables[c].b).s +=
        change[i];
  }
  const Eigen::VectorXd motion = model.motion * step;
  equilibrium::State predicted = system.displaced(at_.state, motion);
  const Eigen::VectorXd density =
      (model.density + model.density_rates * step).cwiseMax(kept_density / 2 * model.density);
  std::vector<bool> gone(cables.size(), false);
  for (const int o : out)
    for (const int c : model.orbits[o]) gone[c] = true;
  std::vector<springs::Cable> left;
  for (std::size_t o = 0; o < model.orbits.size(); ++o)
    for (const int c : model.orbits[o]) {
      const auto stencil =
          springs::stencil(cables[c], system.arc_lengths(), system.structure().anchors);
      const double q = density[static_cast<Eigen::Index>(o)];
      cables[c].rest_length = taut * equilibrium::span_of(stencil, predicted).norm();
      cables[c].stiffness = q / (1 - taut);
    }
  for (std::size_t c = 0; c < cables.size(); ++c)
    if (!gone[c]) left.push_back(cables[c]);
  trial_.system.set_cables(std::move(left));
  auto forces = equilibrium::predicted_forces(system, at_.state, motion);
  // Cables that are kept have the tension that is predicted, others the one that they were given.
  const Eigen::VectorXd kept = forces.tension.head(task_.kept);
  forces.tension = trial_.system.internal_forces(predicted).tension;
  forces.tension.head(task_.kept) = kept;
  const bool settled = settle(std::move(predicted), soft_,
                              {.tolerance = tolerance,
                               .max_iterations = most_iterations,
                               .farthest = farthest,
                               .forces = std::move(forces),
                               .stop = control_.stop});
  if (!settled || !(trial_value_ < accepted)) return false;
  accept();
  return true;
}

void Walker::refit(int steps, double least_gain) {
  constexpr int attempts = 5;
  for (int k = 0; k < steps && cables() > 0 && !stopped(); ++k) {
    const double before = value_;
    bool moved = false;
    for (int attempt = 0; attempt < attempts && !moved; ++attempt) {
      const Planner plan = planner();
      moved = move(plan.model(), plan.step({}, std::pow(0.5, attempt)), {}, value_);
      damping_ = std::clamp(moved ? damping_ / 4 : 8 * damping_, least_damping, most_damping);
    }
    if (!moved || value_ > (1 - least_gain) * before) return;
  }
}

}  // namespace tencer::sparsify
