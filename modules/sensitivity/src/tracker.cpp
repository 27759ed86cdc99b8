#include <algorithm>
#include <cmath>
#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/sensitivity/tracker.hpp>
#include <tencer/springs/law.hpp>
#include <utility>

namespace tencer::sensitivity {
namespace {

using model::State;
using springs::Cable;
using springs::End;

// Part of the way between two attachments, the short way round a closed rod. Requires that both are
// on the same rod or anchor.
End between(const End& from, const End& to, double t, const equilibrium::System& system) {
  constexpr const char* same = "evaluate: the ends of cables must stay on their rods and anchors";
  core::require(from.index() == to.index(), same);
  if (const auto* anchor = std::get_if<springs::AtAnchor>(&from)) {
    core::require(anchor->anchor == std::get<springs::AtAnchor>(to).anchor, same);
    return to;
  }
  const auto& a = std::get<springs::OnRod>(from);
  const auto& b = std::get<springs::OnRod>(to);
  core::require(a.rod == b.rod, same);
  const geometry::ArcLength& rod = system.arc_lengths()[a.rod];
  const double distance =
      rod.closed() ? std::remainder(b.s - a.s, rod.length()) : rod.wrap(b.s) - rod.wrap(a.s);
  return t == 1 ? to : springs::OnRod{a.rod, a.s + t * distance};
}

// Part t of the way from the cables of a configuration to others; for t = 1 those.
std::vector<Cable> between(const Configuration& from, const std::vector<Cable>& to, double t) {
  core::require(to.size() == from.cables().size(), "evaluate: needs all the cables");
  std::vector<Cable> result = to;
  for (std::size_t c = 0; c < to.size(); ++c) {
    const Cable& a = from.cables()[c];
    const Cable& b = to[c];
    core::require(a.tension_only == b.tension_only,
                  "evaluate: a cable must stay tension-only or not");
    result[c].a = between(a.a, b.a, t, from.system);
    result[c].b = between(a.b, b.b, t, from.system);
    result[c].stiffness = std::lerp(a.stiffness, b.stiffness, t);
    result[c].rest_length = std::lerp(a.rest_length, b.rest_length, t);
  }
  return result;
}

// How the forces on the free unknowns change with the cables, the vertices held: to first order in
// the displacement of the attachments (not in s, whose derivative jumps at vertices) and exactly in
// stiffness and rest length, so that rebased cables change nothing.
Eigen::VectorXd force_change(const Configuration& from, const equilibrium::System& to) {
  Eigen::VectorXd change = Eigen::VectorXd::Zero(from.system.size());
  const auto add = [&](const springs::Stencil& stencil, const Eigen::Vector3d& force) {
    to.for_each_unknown(
        stencil, [&](int at, int axis, double weight) { change[at] += weight * force[axis]; });
  };
  for (std::size_t c = 0; c < from.cables().size(); ++c) {
    const Cable& cable = from.cables()[c];
    const Cable& next = to.structure().cables[c];
    const Eigen::Vector3d span = model::span_of(from.system.stencils()[c], from.state);
    const Eigen::Vector3d next_span = model::span_of(to.stencils()[c], from.state);
    const Eigen::Vector3d force = springs::force(cable, span);
    const Eigen::Matrix3d stiffness =
        springs::stiffness_matrix(cable, span, springs::tension(cable, span.norm()));
    add(from.system.stencils()[c],
        springs::force(next, span) - force + stiffness * (next_span - span));
    add(from.system.stencils()[c], -force);
    add(to.stencils()[c], force);
  }
  return change;
}

// Largest motion of a vertex from one state to another, less the rigid motions at `at`: a structure
// that is free to drift may do so.
double largest_motion(const Configuration& at, const State& from, const State& to) {
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(at.system.size());
  const auto for_each_vertex = [&](const auto& visit) {
    for (int r = 0; r < static_cast<int>(from.size()); ++r)
      for (int v = 0; v < from[r].x.cols(); ++v) {
        Eigen::Vector3i index;
        for (int axis = 0; axis < 3; ++axis) index[axis] = at.system.position_index(r, v, axis);
        visit(r, v, index);
      }
  };
  for_each_vertex([&](int r, int v, const Eigen::Vector3i& index) {
    for (int axis = 0; axis < 3; ++axis)
      if (index[axis] >= 0) motion[index[axis]] = to[r].x(axis, v) - from[r].x(axis, v);
  });
  equilibrium::remove_rigid(at.linearisation.rigid, motion);
  double largest = 0;
  for_each_vertex([&](int, int, const Eigen::Vector3i& index) {
    double squared = 0;
    for (const int i : index)
      if (i >= 0) squared += motion[i] * motion[i];
    largest = std::max(largest, squared);
  });
  return std::sqrt(largest);
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

equilibrium::Equilibrium solve(Configuration& at, State start, const TrackerOptions& options,
                               std::optional<equilibrium::InternalForces> forces = {}) {
  // An old matrix may have another pattern; the factor itself notices when it has.
  at.linearisation.matrix = at.system.pattern();
  equilibrium::Equilibrium result = equilibrium::solve(at.system, std::move(start),
                                                       {.tolerance = options.tolerance,
                                                        .max_iterations = options.max_iterations,
                                                        .forces = std::move(forces),
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

Tracker::Tracker(model::Structure structure, State start, TrackerOptions options)
    : options_(std::move(options)),
      committed_{.system = equilibrium::System(structure, options_.side)},
      trial_{.system = equilibrium::System(structure, options_.side)},
      halfway_{.system = equilibrium::System(std::move(structure), options_.side)} {
  core::require(options_.smallest_step > 0 && options_.smallest_step <= 1,
                "tracker: smallest_step must be in (0, 1]");
  first_ = solve(committed_, std::move(start), options_);
}

Trial Tracker::step(const Configuration& from, std::vector<Cable> cables) {
  trial_.system.set_cables(std::move(cables));
  const Eigen::VectorXd motion = from.linearisation.solve(-force_change(from, trial_.system));
  const State predicted = trial_.system.displaced(from.state, motion);
  Trial trial{.motion = largest_motion(from, from.state, predicted)};
  // The energy is no guide here: a good prediction stretches stiff rods to second order, which
  // raises it, and Newton's first step takes that back.
  constexpr double trusted = 0.25;
  const double size = extent(from.state);
  trial.predicted =
      trial.motion <= trusted * size && std::isfinite(trial_.system.energy(predicted));
  trial.equilibrium = trial.predicted
                          ? solve(trial_, predicted, options_,
                                  equilibrium::predicted_forces(trial_.system, from.state, motion))
                          : solve(trial_, from.state, options_);
  trial.correction = largest_motion(from, predicted, trial.equilibrium.state);
  const double allowed =
      std::max(options_.max_correction * trial.motion, options_.negligible * size);
  if (!trial.equilibrium.usable())
    trial.outcome = Outcome::not_solved;
  else if (trial.equilibrium.escapes > 0)
    trial.outcome = Outcome::lost_balance;
  else if (!(trial.correction <= allowed))
    trial.outcome = Outcome::jumped;
  else
    trial.outcome = Outcome::followed;
  return trial;
}

Trial Tracker::evaluate(const std::vector<Cable>& cables) {
  core::require(first_.usable(), "evaluate: there is no equilibrium to start from");
  trial_usable_ = false;
  const Configuration* from = &committed_;
  double done = 0;
  double length = 1;
  for (int solves = 1;; ++solves) {
    Trial trial = step(*from, between(committed_, cables, done + length));
    trial.solves = solves;
    if (trial.usable()) {
      done += length;
      if (done == 1) {
        trial_usable_ = true;
        return trial;
      }
      std::swap(halfway_, trial_);
      from = &halfway_;
    } else {
      length /= 2;
      const bool stopped = trial.equilibrium.reason == equilibrium::Reason::stopped;
      if (length < options_.smallest_step || stopped) return trial;
    }
  }
}

void Tracker::commit() {
  core::require(trial_usable_, "commit: the last trial was not usable");
  std::swap(committed_, trial_);
  trial_usable_ = false;
}

}  // namespace tencer::sensitivity
