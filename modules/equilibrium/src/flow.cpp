#include <algorithm>
#include <cmath>
#include <limits>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/flow.hpp>
#include <tencer/equilibrium/modal.hpp>
#include <utility>

#include "forces.hpp"
#include "pulling_cables.hpp"

namespace tencer::equilibrium {
namespace {

model::Structure sprung(model::Structure structure, const Eigen::VectorXd& tensions) {
  core::require(tensions.size() == static_cast<Eigen::Index>(structure.cables.size()) &&
                    (tensions.size() == 0 || tensions.minCoeff() >= 0),
                "Flow: needs one tension >= 0 per cable");
  for (const auto& cable : structure.cables)
    core::require(cable.rest_length > 0, "Flow: every cable needs a length");
  double stiffness = axial_stiffness(structure);
  auto springs = as_springs(structure, tensions, stiffness);
  while (!springs) springs = as_springs(structure, tensions, stiffness *= 10);
  structure.cables = std::move(*springs);
  return structure;
}

model::Structure bare(model::Structure structure) {
  structure.cables.clear();
  return structure;
}

}  // namespace

Flow::Flow(const model::Structure& structure, const Eigen::VectorXd& tensions)
    : system_(sprung(structure, tensions)),
      rods_(bare(structure)),
      mass_(lumped_mass(system_)),
      unit_(eigenvalue_unit(structure)) {
  for (const auto& rod : structure.rods) longest_ = std::max(longest_, rod.length());
}

FlowPose Flow::at(model::State state) const {
  FlowPose pose{.state = std::move(state)};
  pose.forces = system_.internal_forces(pose.state);
  pose.energy = rods_.energy(pose.state);
  return pose;
}

double Flow::size_of(const model::State& state, const Eigen::VectorXd& motion) const {
  return std::max(largest_rotation(system_, state, motion),
                  largest_motion(system_, motion) / longest_);
}

// The least of energy + holding / 2 |x - from - ahead|^2 by Newton's method from `from` on, at most
// `reach` away and where the second derivatives are positive all along. Steps are those of the
// mixed formulation (solve.hpp), which stretching does not slow.
std::optional<Flow::Moved> Flow::least_near(const FlowPose& from, const Eigen::VectorXd& ahead,
                                            const Eigen::VectorXd& holding, double reach) {
  constexpr int most = 12;
  constexpr double near = 1e-6;
  model::State state = from.state;
  InternalForces forces = from.forces;
  Eigen::VectorXd gone = Eigen::VectorXd::Zero(system_.size());
  Eigen::VectorXd step;
  linalg::SymmetricMatrix matrix = system_.pattern();
  for (int k = 0; k < most; ++k) {
    system_.hessian(state, forces, matrix);
    for (int i = 0; i < matrix.cols(); ++i) matrix.coeffRef(i, i) += holding[i];
    if (!factor_.factorise(matrix) || factor_.inertia().negative != system_.saddle_unknowns())
      return std::nullopt;
    // Further steps with the same factor, while each is much shorter than the last.
    for (double last = std::numeric_limits<double>::infinity();;) {
      factor_.solve(-system_.gradient(state) - holding.cwiseProduct(gone - ahead), step);
      const double size = size_of(state, step);
      if (!(size < last / 10)) break;
      last = size;
      reach -= size;
      if (!(reach >= 0)) return std::nullopt;
      forces = predicted_forces(system_, state, step);
      system_.displace(state, step);
      gone += step;
      if (size <= near) {
        return Moved{
            .pose = {.state = state, .forces = std::move(forces), .energy = rods_.energy(state)},
            .moved = largest_motion(system_, gone) / longest_,
            .size = size_of(from.state, gone)};
      }
    }
  }
  return std::nullopt;
}

Descent Flow::descend(FlowPose from, const FlowOptions& options) {
  constexpr double first = 1e4, slowest = 1e-2, fastest = 1e12;  // rates, in unit_
  constexpr double still = 1e-5;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(system_.size());
  Descent result;
  result.poses.push_back(std::move(from));
  double rate = first;
  while (static_cast<int>(result.poses.size()) <= options.max_steps && rate < fastest &&
         !options.stop.stop_requested()) {
    if (options.arrived && options.arrived(result.poses.back())) {
      result.rests = true;
      break;
    }
    auto next = least_near(result.poses.back(), none, rate * unit_ * mass_, 2 * options.max_step);
    if (!next || next->size > options.max_step) {
      rate *= 4;
      continue;
    }
    next->pose.speed = rate * next->moved;
    result.poses.push_back(std::move(next->pose));
    if (next->size < still && rate <= slowest) {
      result.rests = true;
      break;
    }
    const double faster = std::clamp(next->size / (0.6 * options.max_step), 0.3, 1.5);
    rate = std::max(rate * faster, slowest);
  }
  return result;
}

std::optional<FlowPose> Flow::drawn(const FlowPose& from, const Eigen::VectorXd& ahead,
                                    const Eigen::VectorXd& springs) {
  constexpr double reach = 1;
  auto moved = least_near(from, ahead, unit_ * mass_.cwiseProduct(springs), reach);
  if (!moved) return std::nullopt;
  return std::move(moved->pose);
}

}  // namespace tencer::equilibrium
