#include <algorithm>
#include <cmath>
#include <tencer/certify/own_weight.hpp>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/constrained.hpp>
#include <tencer/equilibrium/modal.hpp>
#include <tencer/sensitivity/distance.hpp>

namespace tencer::certify {
namespace {

using equilibrium::System;

struct Vertex {
  int rod = 0;
  int vertex = 0;
};

std::vector<Vertex> spread(const model::State& state, int tries) {
  std::vector<Vertex> result;
  for (int r = 0; r < static_cast<int>(state.size()); ++r) {
    const auto n = static_cast<int>(state[r].x.cols());
    const int some = std::min(tries, n);
    for (int i = 0; i < some; ++i) result.push_back({r, i * (n - 1) / std::max(some - 1, 1)});
  }
  return result;
}

// The weight of every unknown's vertex along `down`; weight: of coordinates, whatever their axis.
Eigen::VectorXd pull(const System& system, const Eigen::VectorXd& weight,
                     const Eigen::Vector3d& down) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(system.size());
  const auto& rods = system.structure().rods;
  for (int r = 0; r < static_cast<int>(rods.size()); ++r)
    for (int v = 0; v < rods[r].vertices(); ++v)
      for (int axis = 0; axis < 3; ++axis)
        if (const int at = system.position_index(r, v, axis); at >= 0)
          force[at] = weight[at] * down[axis];
  return force;
}

struct Heavy {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double weight = 0.0;
};

Heavy heavy(const model::Structure& structure, const model::State& state,
            const Eigen::VectorXd& weight_per_length) {
  Heavy result;
  for (std::size_t r = 0; r < state.size(); ++r) {
    const auto& x = state[r].x;
    const auto& lengths = structure.rods[r].rest_lengths;
    for (Eigen::Index j = 0; j < lengths.size(); ++j) {
      const double weight = weight_per_length[static_cast<Eigen::Index>(r)] * lengths[j];
      result.middle += weight * (x.col(j) + x.col((j + 1) % x.cols())) / 2;
      result.weight += weight;
    }
  }
  result.middle /= result.weight;
  return result;
}

}  // namespace

Sag own_weight_sag(const model::Structure& structure, const model::State& state,
                   const Eigen::VectorXd& tensions, const Eigen::VectorXd& weight_per_length,
                   int tries) {
  core::require(weight_per_length.size() == static_cast<Eigen::Index>(structure.rods.size()) &&
                    (weight_per_length.array() > 0).all() && weight_per_length.allFinite(),
                "own_weight_sag: needs a positive weight per length for every rod");
  core::require(tries >= 1, "own_weight_sag: needs tries >= 1");
  const System system =
      equilibrium::taut_system(structure, state, tensions, equilibrium::taut_cables(tensions));
  equilibrium::ConstrainedHessian hessian(system, state,
                                          equilibrium::length_gradients(system, state),
                                          equilibrium::lumped_mass(system));
  std::vector<Eigen::Matrix3Xd> pose;
  for (const auto& rod : state) pose.push_back(rod.x);
  const model::Target target = model::make_target(structure, std::move(pose));
  const Eigen::Index motions = hessian.rigid().empty() ? 0 : hessian.rigid()[0].basis.cols();
  const bool swings = !target.align && motions > 0;
  if (hessian.rigid().size() > 1 || swings || !hessian.factorise()) return {};

  const Eigen::VectorXd weight = equilibrium::lumped_mass(system, weight_per_length);
  const Heavy all = heavy(structure, state, weight_per_length);
  std::vector<Vertex> places{{.rod = -1, .vertex = -1}};
  if (target.align) places = spread(state, tries);
  Eigen::MatrixXd forces(system.size(), static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto [rod, vertex] = places[i];
    Eigen::Vector3d down = structure.planar ? -Eigen::Vector3d::UnitY() : -Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d below =
        rod >= 0 ? Eigen::Vector3d(all.middle - state[rod].x.col(vertex)) : down;
    // Hung from its very middle it may stand any way.
    if (below.norm() > 1e-9 * model::diagonal(target)) down = below.normalized();
    Eigen::VectorXd force = pull(system, weight, down);
    if (rod >= 0)
      for (int axis = 0; axis < 3; ++axis)
        if (const int at = system.position_index(rod, vertex, axis); at >= 0)
          force[at] -= all.weight * down[axis];
    forces.col(static_cast<Eigen::Index>(i)) = force;
  }
  const auto none =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(system.stencils().size()), forces.cols());
  const Eigen::MatrixXd moved = sensitivity::Distance(target, system, state)
                                    .residual_rates(hessian.respond(forces, none).motion);
  Sag best;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double sag = moved.col(static_cast<Eigen::Index>(i))
                           .reshaped(3, moved.rows() / 3)
                           .colwise()
                           .norm()
                           .maxCoeff();
    if (best.computed && !(sag < best.deviation)) continue;
    best = {.deviation = sag,
            .rod = places[i].rod,
            .vertex = places[i].vertex,
            .computed = std::isfinite(sag)};
  }
  return best;
}

}  // namespace tencer::certify
