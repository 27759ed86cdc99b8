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

Positions positions_of(const model::State& state) {
  Positions positions;
  for (const auto& rod : state) positions.push_back(rod.x);
  return positions;
}

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

}  // namespace

PushedRest push_and_release(const model::Structure& structure, const model::State& state,
                            const VibrationModes& modes, const Push& push,
                            const std::stop_token& stop) {
  core::require(push.size > 0 && std::isfinite(push.size), "push_and_release: needs a size");
  core::require(push.modes >= 1 && modes.computed && !modes.shapes.empty(),
                "push_and_release: needs modes");
  model::Structure rods = structure;
  rods.cables.clear();
  const System system(rods);
  const model::Target target = model::make_target(structure, positions_of(state));
  const model::State pushed = system.displaced(state, step_of(system, modes, push));
  auto found = equilibrium::relax_inextensible(structure, pushed, {.stop = stop});
  PushedRest result{.rests = found.equilibrium.usable(), .state = found.equilibrium.state};
  const auto deviation = sensitivity::deviation(target, result.state);
  result.deviation = deviation.max;
  result.energy = system.energy(result.state) - system.energy(state);
  const Eigen::Matrix3d back = deviation.motion.rotation.transpose();
  Positions rest = positions_of(result.state);
  for (auto& rod : rest) rod = back * (rod.colwise() - deviation.motion.translation);
  result.strands_met = strands_meet(structure, positions_of(state), positions_of(pushed)) ||
                       strands_meet(structure, positions_of(pushed), rest);
  return result;
}

}  // namespace tencer::certify
