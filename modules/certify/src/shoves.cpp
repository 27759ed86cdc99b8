#include <algorithm>
#include <cmath>
#include <tencer/certify/shoves.hpp>
#include <tencer/certify/strands.hpp>
#include <tencer/certify/tolerance.hpp>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/sensitivity/distance.hpp>

namespace tencer::certify {
namespace {

using equilibrium::System;
using Positions = std::vector<Eigen::Matrix3Xd>;

// The step of the free unknowns that moves the vertices by a drawn combination of modes.
Eigen::VectorXd step_of(const System& system, const VibrationModes& modes, const Push& push) {
  const int count = std::min(push.modes, static_cast<int>(modes.shapes.size()));
  const Eigen::MatrixXd parts = unit_draws(count, 1, push.seed);
  Positions moved = modes.shapes[0];
  for (auto& rod : moved) rod.setZero();
  for (int m = 0; m < count; ++m)
    for (std::size_t r = 0; r < moved.size(); ++r) moved[r] += parts(m, 0) * modes.shapes[m][r];
  double largest = 0;
  for (const auto& rod : moved) largest = std::max(largest, rod.colwise().norm().maxCoeff());
  Eigen::VectorXd step = Eigen::VectorXd::Zero(system.size());
  for (int r = 0; r < static_cast<int>(moved.size()); ++r)
    for (int v = 0; v < moved[r].cols(); ++v)
      for (int axis = 0; axis < 3; ++axis)
        if (const int at = system.position_index(r, v, axis); at >= 0)
          step[at] = push.size / largest * moved[r](axis, v);
  return step;
}

model::Structure without_cables(model::Structure structure) {
  structure.cables.clear();
  return structure;
}

model::State pushed_state(const System& system, const model::State& state,
                          const VibrationModes& modes, const Push& push) {
  core::require(push.size > 0 && std::isfinite(push.size), "push_and_release: needs a size");
  core::require(push.modes >= 1 && modes.computed && !modes.shapes.empty(),
                "push_and_release: needs modes");
  return system.displaced(state, step_of(system, modes, push));
}

// The positions moved onto the target.
Positions aligned(const model::Target& target, const model::State& state) {
  const auto motion = sensitivity::deviation(target, state).motion;
  Positions positions = model::positions_of(state);
  for (auto& rod : positions)
    rod = motion.rotation.transpose() * (rod.colwise() - motion.translation);
  return positions;
}

}  // namespace

PushedRest push_and_release(const model::Structure& structure, const model::State& state,
                            const VibrationModes& modes, const Push& push,
                            const std::stop_token& stop) {
  const System system(without_cables(structure));
  const model::Target target = model::make_target(structure, model::positions_of(state));
  const model::State pushed = pushed_state(system, state, modes, push);
  auto found = equilibrium::relax_inextensible(structure, pushed, {.stop = stop});
  PushedRest result{.rests = found.equilibrium.usable(), .state = found.equilibrium.state};
  result.deviation = sensitivity::deviation(target, result.state).max;
  result.energy = system.energy(result.state) - system.energy(state);
  const Positions rest = aligned(target, result.state);
  result.strands_met =
      strands_meet(structure, model::positions_of(state), model::positions_of(pushed)) ||
      strands_meet(structure, model::positions_of(pushed), rest);
  return result;
}

std::vector<Positions> way_of(const model::Structure& structure, const model::State& state,
                              const VibrationModes& modes, const Push& push) {
  constexpr int most_steps = 40;
  const System system(without_cables(structure));
  const model::Target target = model::make_target(structure, model::positions_of(state));
  const model::State pushed = pushed_state(system, state, modes, push);
  std::vector<Positions> way{aligned(target, pushed)};
  bool rests = false;
  for (int steps = 1; steps <= most_steps && !rests; ++steps) {
    const auto found =
        equilibrium::relax_inextensible(structure, pushed, {.max_iterations = steps}).equilibrium;
    way.push_back(aligned(target, found.state));
    rests = found.usable();
  }
  if (!rests)
    way.push_back(
        aligned(target, equilibrium::relax_inextensible(structure, pushed).equilibrium.state));
  return way;
}

}  // namespace tencer::certify
