#include <algorithm>
#include <cmath>
#include <tencer/certify/own_weight.hpp>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/constrained.hpp>
#include <tencer/equilibrium/modal.hpp>
#include <tencer/equilibrium/path.hpp>
#include <tencer/sensitivity/distance.hpp>

namespace tencer::certify {
namespace {

using equilibrium::System;

std::vector<Support> spread(const model::State& state, int tries) {
  std::vector<Support> result;
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

// A pose with weight, to first order and beyond.
class Weighed {
 public:
  Weighed(const model::Structure& structure, const model::State& state,
          const Eigen::VectorXd& tensions, const Eigen::VectorXd& weight_per_length)
      : structure_(structure),
        state_(state),
        tensions_(tensions),
        weight_per_length_(weight_per_length),
        system_(equilibrium::taut_system(structure, state, tensions,
                                         equilibrium::taut_cables(tensions))),
        hessian_(system_, state, equilibrium::length_gradients(system_, state),
                 equilibrium::lumped_mass(system_)),
        weight_(equilibrium::lumped_mass(system_, weight_per_length)),
        target_(model::make_target(structure, model::positions_of(state))) {}

  const model::Target& target() const { return target_; }

  // false: the pose has no first order.
  bool factorise() {
    const Eigen::Index motions = hessian_.rigid().empty() ? 0 : hessian_.rigid()[0].basis.cols();
    const bool swings = !target_.align && motions > 0;
    return hessian_.rigid().size() <= 1 && !swings && hessian_.factorise();
  }

  // The weight along `down`, and what a support (if any) bears of it: all.
  Eigen::VectorXd pull(const Eigen::Vector3d& down, const Support* support) const {
    Eigen::VectorXd force = certify::pull(system_, weight_, down);
    if (!support) return force;
    const auto& rods = structure_.rods;
    double all = 0;
    for (std::size_t r = 0; r < rods.size(); ++r)
      all += weight_per_length_[static_cast<Eigen::Index>(r)] * rods[r].length();
    for (int axis = 0; axis < 3; ++axis)
      if (const int at = system_.position_index(support->rod, support->vertex, axis); at >= 0)
        force[at] -= all * down[axis];
    return force;
  }

  // The largest distance of a vertex for each column of forces.
  Eigen::VectorXd deviations(const Eigen::MatrixXd& forces) const {
    const auto none =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(system_.stencils().size()), forces.cols());
    const Eigen::MatrixXd moved = sensitivity::Distance(target_, system_, state_)
                                      .residual_rates(hessian_.respond(forces, none).motion);
    Eigen::VectorXd result(forces.cols());
    for (Eigen::Index i = 0; i < forces.cols(); ++i)
      result[i] = moved.col(i).reshaped(3, moved.rows() / 3).colwise().norm().maxCoeff();
    return result;
  }

  // `sag`, let settle where it is too large for a first order.
  Sag settled(Sag sag, const Eigen::Vector3d& down, const std::stop_token& stop) const {
    constexpr double first_order_percent = 1;
    if (!sag.computed || sag.deviation <= first_order_percent / 100 * model::diagonal(target_))
      return sag;
    model::Structure heavy = structure_;
    for (const auto& [rod, vertex] : sag.at) heavy.pins.push_back({.rod = rod, .vertex = vertex});
    for (int r = 0; r < static_cast<int>(heavy.rods.size()); ++r)
      heavy.line_loads.push_back({.rod = r, .force_per_length = weight_per_length_[r] * down});
    const equilibrium::PathStart start(heavy, state_, tensions_);
    for (std::size_t c = 0; c < heavy.cables.size(); ++c)
      heavy.cables[c].rest_length = start.lengths()[static_cast<Eigen::Index>(c)];
    equilibrium::Equilibrium rest;
    if (target_.align) {  // without weight nothing keeps it from swinging: there is no path
      rest = equilibrium::relax_inextensible(heavy, state_, tensions_, {.stop = stop}).equilibrium;
      sag.falls = !rest.usable();
    } else {
      auto found = equilibrium::settle_along(start, start.lengths(), {.solve = {.stop = stop}});
      rest = std::move(found.rest.equilibrium);
      sag.falls = !found.followed();
    }
    sag.settled = true;
    sag.deviation = sensitivity::deviation(target_, rest.state).max;
    return sag;
  }

 private:
  const model::Structure& structure_;
  const model::State& state_;
  const Eigen::VectorXd& tensions_;
  const Eigen::VectorXd& weight_per_length_;
  System system_;
  equilibrium::ConstrainedHessian hessian_;
  Eigen::VectorXd weight_;
  model::Target target_;
};

// Of one that its supports hold.
Sag held_sag(Weighed& pose, const Eigen::Vector3d& down, const std::stop_token& stop) {
  if (!pose.factorise()) return {};
  const double deviation = pose.deviations(pose.pull(down, nullptr))[0];
  return pose.settled({.deviation = deviation, .computed = std::isfinite(deviation)}, down, stop);
}

}  // namespace

Sag own_weight_sag(const model::Structure& structure, const model::State& state,
                   const Eigen::VectorXd& tensions, const Eigen::VectorXd& weight_per_length,
                   int tries, const std::stop_token& stop) {
  core::require(tries >= 1, "own_weight_sag: needs tries >= 1");
  const Eigen::Vector3d middle = centre_of_mass(structure, state, weight_per_length);
  const Eigen::Vector3d usual =
      structure.planar ? -Eigen::Vector3d::UnitY() : -Eigen::Vector3d::UnitZ();
  Weighed pose(structure, state, tensions, weight_per_length);
  if (!pose.target().align) return held_sag(pose, usual, stop);
  if (!pose.factorise()) return {};
  const std::vector<Support> places = spread(state, tries);
  std::vector<Eigen::Vector3d> down;
  std::vector<Eigen::VectorXd> forces;
  for (const Support& place : places) {
    const Eigen::Vector3d below = middle - state[place.rod].x.col(place.vertex);
    // Hung from its very middle it may stand any way.
    down.push_back(below.norm() > 1e-9 * model::diagonal(pose.target())
                       ? Eigen::Vector3d(below.normalized())
                       : usual);
    forces.push_back(pose.pull(down.back(), &place));
  }
  Eigen::MatrixXd all(forces[0].size(), static_cast<Eigen::Index>(forces.size()));
  for (std::size_t i = 0; i < forces.size(); ++i) all.col(static_cast<Eigen::Index>(i)) = forces[i];
  const Eigen::VectorXd deviations = pose.deviations(all);
  Eigen::Index best = 0;
  const double least = deviations.minCoeff(&best);
  const auto at = static_cast<std::size_t>(best);
  return pose.settled({.deviation = least, .at = {places[at]}, .computed = std::isfinite(least)},
                      down[at], stop);
}

Sag standing_sag(const model::Structure& structure, const model::State& state,
                 const Eigen::VectorXd& tensions, const Eigen::VectorXd& weight_per_length,
                 const Stance& stance, const std::stop_token& stop) {
  model::Structure standing = structure;
  for (const auto& [rod, vertex] : stance.feet)
    standing.pins.push_back({.rod = rod, .vertex = vertex});
  Weighed pose(standing, state, tensions, weight_per_length);
  Sag sag = held_sag(pose, stance.down, stop);
  sag.at.assign(stance.feet.begin(), stance.feet.end());
  return sag;
}

}  // namespace tencer::certify
