#include <algorithm>
#include <cmath>
#include <tencer/certify/shoves.hpp>
#include <tencer/certify/tolerance.hpp>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/geometry/measure.hpp>
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

struct EdgeVertices {
  int rod = 0;
  int a = 0;  // its vertices
  int b = 0;
};

// Whether two edges that share no vertex come nearer than they move against each other in a step,
// on the straight way from one place to the other in equal steps.
bool strands_meet(const model::Structure& structure, const Positions& from, const Positions& to) {
  constexpr int steps = 16;
  std::vector<EdgeVertices> edges;
  for (int r = 0; r < static_cast<int>(from.size()); ++r)
    for (int j = 0; j < structure.rods[r].edges(); ++j)
      edges.push_back({r, j, (j + 1) % structure.rods[r].vertices()});
  const auto move = [&](int rod, int v) -> Eigen::Vector3d {
    return to[rod].col(v) - from[rod].col(v);
  };
  const auto relative = [&](const EdgeVertices& one, const EdgeVertices& other) {
    double largest = 0;
    for (const int v : {one.a, one.b})
      for (const int w : {other.a, other.b})
        largest = std::max(largest, (move(one.rod, v) - move(other.rod, w)).norm());
    return largest;
  };
  const auto distance = [&](const EdgeVertices& one, const EdgeVertices& other, double t) {
    const auto at = [&](int rod, int v) -> Eigen::Vector3d {
      return (1 - t) * from[rod].col(v) + t * to[rod].col(v);
    };
    return geometry::segment_approach(at(one.rod, one.a), at(one.rod, one.b),
                                      at(other.rod, other.a), at(other.rod, other.b))
        .distance;
  };
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const EdgeVertices& one = edges[i];
      const EdgeVertices& other = edges[j];
      const bool neighbours = one.rod == other.rod && (one.a == other.b || one.b == other.a);
      if (neighbours) continue;
      const double against = relative(one, other);
      if (distance(one, other, 0) > against) continue;
      for (int k = 0; k <= steps; ++k)
        if (distance(one, other, static_cast<double>(k) / steps) < against / steps) return true;
    }
  return false;
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
