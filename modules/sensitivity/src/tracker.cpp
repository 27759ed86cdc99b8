#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/sensitivity/parameters.hpp>
#include <tencer/sensitivity/tracker.hpp>
#include <utility>

namespace tencer::sensitivity {
namespace {

using equilibrium::State;
using springs::Cable;
using springs::End;

// How far an end's attachment slides, the short way round a closed rod; nothing for anchors.
// Requires that both are on the same rod or anchor.
double slide(const End& from, const End& to, const std::vector<geometry::ArcLength>& rods) {
  constexpr const char* same = "evaluate: the ends of cables must stay on their rods and anchors";
  core::require(from.index() == to.index(), same);
  if (const auto* anchor = std::get_if<springs::AtAnchor>(&from)) {
    core::require(anchor->anchor == std::get<springs::AtAnchor>(to).anchor, same);
    return 0.0;
  }
  const auto& a = std::get<springs::OnRod>(from);
  const auto& b = std::get<springs::OnRod>(to);
  core::require(a.rod == b.rod, same);
  const geometry::ArcLength& rod = rods[a.rod];
  return rod.closed() ? std::remainder(b.s - a.s, rod.length()) : rod.wrap(b.s) - rod.wrap(a.s);
}

// The motion of the free unknowns that changed cables cause, to first order.
Eigen::VectorXd predicted_motion(const Configuration& from, const std::vector<Cable>& cables) {
  core::require(cables.size() == from.cables().size(), "evaluate: needs all the cables");
  std::vector<Parameter> parameters;
  std::vector<double> changes;
  const auto add = [&](Kind kind, int cable, double change) {
    if (change == 0) return;
    parameters.push_back({kind, cable});
    changes.push_back(change);
  };
  const auto& rods = from.system.arc_lengths();
  for (int c = 0; c < static_cast<int>(cables.size()); ++c) {
    const Cable& now = from.cables()[c];
    const Cable& next = cables[c];
    core::require(now.tension_only == next.tension_only,
                  "evaluate: a cable must stay tension-only or not");
    add(Kind::stiffness, c, next.stiffness - now.stiffness);
    add(Kind::rest_length, c, next.rest_length - now.rest_length);
    add(Kind::position_a, c, slide(now.a, next.a, rods));
    add(Kind::position_b, c, slide(now.b, next.b, rods));
  }
  if (parameters.empty()) return Eigen::VectorXd::Zero(from.system.size());
  const Eigen::VectorXd change =
      Eigen::Map<const Eigen::VectorXd>(changes.data(), static_cast<Eigen::Index>(changes.size()));
  const Eigen::VectorXd force = force_derivatives(from.system, from.state, parameters) * change;
  return from.linearisation.solve(-force);
}

double largest_distance(const State& a, const State& b) {
  double squared = 0;
  for (std::size_t r = 0; r < a.size(); ++r)
    squared = std::max(squared, (a[r].x - b[r].x).colwise().squaredNorm().maxCoeff());
  return std::sqrt(squared);
}

// Diagonal of the bounding box.
double extent(const State& state) {
  Eigen::Vector3d low = state.front().x.col(0);
  Eigen::Vector3d high = low;
  for (const auto& rod : state) {
    low = low.cwiseMin(rod.x.rowwise().minCoeff());
    high = high.cwiseMax(rod.x.rowwise().maxCoeff());
  }
  return (high - low).norm();
}

// Newton stops where rounding may be all that is left of the forces; whatever else is left would
// show in derivatives by differences. A step with the factor at hand costs next to nothing.
void polish(Configuration& at, equilibrium::Equilibrium& report) {
  constexpr int most = 3;
  Eigen::VectorXd gradient = at.system.gradient(report.state);
  for (int k = 0; k < most; ++k) {
    State moved = at.system.displaced(report.state, at.linearisation.solve(-gradient));
    Eigen::VectorXd left = at.system.gradient(moved);
    if (!(left.norm() < gradient.norm() / 2)) return;
    report.residual *= left.norm() / gradient.norm();
    report.state = std::move(moved);
    gradient = std::move(left);
  }
}

equilibrium::Equilibrium solve(Configuration& at, State start, const TrackerOptions& options) {
  // An old matrix may have another pattern; the factor itself notices when it has.
  at.linearisation.matrix = at.system.pattern();
  equilibrium::Equilibrium result = equilibrium::solve(at.system, std::move(start),
                                                       {.tolerance = options.tolerance,
                                                        .max_iterations = options.max_iterations,
                                                        .stop = options.stop},
                                                       at.linearisation);
  if (result.usable()) polish(at, result);
  at.state = result.state;
  return result;
}

}  // namespace

std::string describe(Outcome outcome) {
  switch (outcome) {
    case Outcome::followed:
      return "the equilibrium was followed";
    case Outcome::jumped:
      return "the equilibrium is far from where it was expected";
    case Outcome::lost_balance:
      return "the equilibrium became unstable on the way";
    case Outcome::not_solved:
      return "no stable equilibrium was found";
  }
  return {};
}

Tracker::Tracker(equilibrium::Structure structure, State start, TrackerOptions options)
    : options_(std::move(options)),
      committed_{.system = equilibrium::System(structure, options_.side)},
      trial_{.system = equilibrium::System(std::move(structure), options_.side)} {
  first_ = solve(committed_, std::move(start), options_);
}

Trial Tracker::evaluate(std::vector<Cable> cables) {
  core::require(first_.usable(), "evaluate: there is no equilibrium to start from");
  const Eigen::VectorXd motion = predicted_motion(committed_, cables);
  trial_usable_ = false;
  trial_.system.set_cables(std::move(cables));
  const State predicted = committed_.system.displaced(committed_.state, motion);
  Trial trial{.motion = largest_distance(predicted, committed_.state)};
  const double energy = trial_.system.energy(predicted);
  trial.predicted = std::isfinite(energy) && energy < trial_.system.energy(committed_.state);
  trial.equilibrium = solve(trial_, trial.predicted ? predicted : committed_.state, options_);
  trial.correction = largest_distance(trial.equilibrium.state, predicted);
  const double allowed = std::max(options_.max_correction * trial.motion,
                                  options_.negligible * extent(committed_.state));
  if (!trial.equilibrium.usable())
    trial.outcome = Outcome::not_solved;
  else if (trial.equilibrium.escapes > 0)
    trial.outcome = Outcome::lost_balance;
  else if (!(trial.correction <= allowed))
    trial.outcome = Outcome::jumped;
  else
    trial.outcome = Outcome::followed;
  trial_usable_ = trial.usable();
  return trial;
}

void Tracker::commit() {
  core::require(trial_usable_, "commit: the last trial was not usable");
  std::swap(committed_, trial_);
  trial_usable_ = false;
}

}  // namespace tencer::sensitivity
