#include "branch_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tencer/equilibrium/modal.hpp>

#include "forces.hpp"
#include "pulling_cables.hpp"

namespace tencer::equilibrium {

BranchSteps::BranchSteps(const model::Structure& structure, const Eigen::VectorXd& start_lengths,
                         const Eigen::VectorXd& lengths)
    : system_(structure), start_lengths_(start_lengths), change_(lengths - start_lengths) {
  double total = 0;
  for (const auto& rod : structure.rods) {
    longest_ = std::max(longest_, rod.length());
    total += rod.length();
    for (const double stiffness : {rod.section.EI1, rod.section.EI2})
      force_ = std::max(force_, stiffness / (rod.length() * rod.length()));
  }
  constexpr double least = 1e-3;
  metric_ = lumped_mass(system_) / (total * longest_ * longest_);
  const double change = change_.size() > 0 ? change_.cwiseAbs().maxCoeff() : 0;
  rate_ = std::pow(std::max(change / longest_, least), 2);
}

std::optional<Spot> BranchSteps::start(const model::State& state, const Eigen::VectorXd& tensions) {
  constexpr double reach = 0.05;
  Spot spot;
  spot.pose = {.state = state, .forces = system_.internal_forces(state)};
  spot.pose.forces.tension = tensions;
  for (const double tension : tensions) spot.pose.taut.push_back(tension > 0);
  Gone gone{.motion = Eigen::VectorXd::Zero(system_.size())};
  if (!correct(spot.pose, at_part(0), gone, reach) || !find_tangent(spot, at_part(1)))
    return std::nullopt;
  return spot;
}

std::optional<Spot> BranchSteps::reached(const Spot& from, double length,
                                         std::optional<double> part) {
  constexpr double departure = 0.5;
  constexpr double same_way = 0.8;  // cosine
  const WayEquation on = along(from.tangent, length);
  Gone gone{.motion = length * from.tangent.motion, .part = length * from.tangent.part};
  Spot spot{.pose = from.pose};
  move(spot.pose, gone.motion, gone.part,
       from.pose.forces.tension + length * from.tangent.tensions);
  const double reach = departure * size(from.pose, gone.motion) + 1e-6;
  if (!correct(spot.pose, part ? at_part(*part - from.pose.part) : on, gone, reach) ||
      !find_tangent(spot, along(from.tangent, 1)))
    return std::nullopt;
  if (part) spot.pose.part = *part;
  spot.gone = on.along.dot(gone.motion) + on.rate * gone.part;
  const double cosine = on.along.dot(spot.tangent.motion) + on.rate * spot.tangent.part;
  return cosine >= same_way ? std::optional(std::move(spot)) : std::nullopt;
}

bool BranchSteps::toggle(Spot& spot, Eigen::Index cable) {
  const auto c = static_cast<std::size_t>(cable);
  const bool taut = !spot.pose.taut[c];
  spot.pose.taut[c] = taut;
  spot.pose.forces.tension[cable] = 0;
  if (!find_tangent(spot, along(spot.tangent, 1))) return false;
  BranchTangent& tangent = spot.tangent;
  const double margin_grows =
      taut ? tangent.tensions[cable]
           : change_[cable] * tangent.part - at_.growth(tangent.motion)[cable];
  if (margin_grows < 0) {
    tangent.motion *= -1;
    tangent.tensions *= -1;
    tangent.part *= -1;
  }
  return true;
}

double BranchSteps::margin(const BranchPose& pose, Eigen::Index cable) const {
  const auto c = static_cast<std::size_t>(cable);
  if (pose.taut[c]) return pose.forces.tension[cable] / force_;
  const double length = model::span_of(system_.stencils()[c], pose.state).norm();
  return (start_lengths_[cable] + pose.part * change_[cable] - length) / longest_;
}

Eigen::Index BranchSteps::beyond(const BranchPose& pose) const {
  constexpr double negligible = 1e-9;
  Eigen::Index worst = -1;
  for (Eigen::Index c = 0; c < change_.size(); ++c)
    if (margin(pose, c) < (worst < 0 ? -negligible : margin(pose, worst))) worst = c;
  return worst;
}

double BranchSteps::pace(const Spot& spot) const {
  return std::max(size(spot.pose, spot.tangent.motion),
                  std::sqrt(rate_) * std::abs(spot.tangent.part));
}

double BranchSteps::size(const BranchPose& pose, const Eigen::VectorXd& motion) const {
  return std::max(largest_rotation(system_, pose.state, motion),
                  largest_motion(system_, motion) / longest_);
}

void BranchSteps::move(BranchPose& pose, const Eigen::VectorXd& motion, double part,
                       const Eigen::VectorXd& tensions) const {
  pose.forces = predicted_forces(system_, pose.state, motion);
  system_.displace(pose.state, motion);
  pose.forces.tension = tensions;
  pose.part += part;
}

// Newton's method for the equilibrium at which the equation holds from where it has `gone`; no
// further than `reach` from `pose`.
bool BranchSteps::correct(BranchPose& pose, const WayEquation& equation, Gone& gone, double reach) {
  constexpr int most = 8;
  constexpr double near = 1e-7;
  for (int k = 0; k < most; ++k) {
    if (!at_.linearise(system_, pose.state, pose.forces, pose.taut)) return false;
    double last = std::numeric_limits<double>::infinity();
    for (bool gaining = true; gaining;) {
      WayEquation left = equation;
      left.ahead -= equation.along.dot(gone.motion) + equation.rate * gone.part;
      const HeldStep next = at_.step(
          gradient_with(system_, pose.state, pose.forces.tension), pose.forces.tension,
          start_lengths_ + pose.part * change_ - cable_lengths(system_, pose.state), change_, left);
      if (!next.solved) return false;
      const double step = size(pose, next.motion);
      reach -= step;
      if (!(reach >= 0)) return false;
      move(pose, next.motion, next.part, next.tensions);
      gone.motion += next.motion;
      gone.part += next.part;
      if (step <= near) return true;
      gaining = step < last / 10;
      last = step;
    }
  }
  return false;
}

// Of spot.pose, on from where the equation leads.
bool BranchSteps::find_tangent(Spot& spot, const WayEquation& equation) {
  const BranchPose& pose = spot.pose;
  if (!at_.linearise(system_, pose.state, pose.forces, pose.taut)) return false;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(change_.size());
  const HeldStep step =
      at_.step(Eigen::VectorXd::Zero(system_.size()), none, none, change_, equation);
  if (!step.solved) return false;
  const double length =
      std::sqrt(step.motion.cwiseAbs2().dot(metric_) + rate_ * step.part * step.part);
  if (!(length > 0) || !std::isfinite(length)) return false;
  spot.negative = at_.negative();
  spot.tangent = {step.motion / length, step.tensions / length, step.part / length};
  return true;
}

// The equation of being so far along a tangent.
WayEquation BranchSteps::along(const BranchTangent& tangent, double length) const {
  return {metric_.cwiseProduct(tangent.motion), rate_ * tangent.part, length};
}

// The equation of a part of the way.
WayEquation BranchSteps::at_part(double ahead) const {
  return {Eigen::VectorXd::Zero(system_.size()), 1, ahead};
}

}  // namespace tencer::equilibrium
