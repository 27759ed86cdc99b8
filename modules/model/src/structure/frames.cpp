#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tencer/der/energy.hpp>
#include <tencer/model/frames.hpp>

namespace tencer::model {

void turn_frames(der::RodState& state, const Eigen::Vector3d& m1) {
  if (state.theta.size() == 0) return;
  const double first = state.theta[0];
  der::set_material_frame(state, 0, m1);
  state.theta.tail(state.theta.size() - 1).array() += state.theta[0] - first;
}

void turn_to_least_energy(const der::Rod& rod, der::RodState& state) {
  constexpr int angles = 16;
  if (state.theta.size() == 0) return;
  const Eigen::VectorXd theta = state.theta;
  double least = std::numeric_limits<double>::infinity();
  Eigen::VectorXd best = theta;
  for (int k = 0; k < angles; ++k) {
    state.theta = theta.array() + 2 * std::numbers::pi * k / angles;
    const double energy = der::energy(rod, state);
    if (energy < least * (1 - 1e-9)) {
      least = energy;
      best = state.theta;
    }
  }
  state.theta = best;
}

void set_frames(der::RodState& state, const Eigen::Matrix3Xd& m1) {
  if (state.theta.size() == 0) return;
  const Eigen::VectorXd before = state.theta;
  double last = 0;
  for (int j = 0; j < state.theta.size(); ++j) {
    der::set_material_frame(state, j, m1.col(j));
    const double turn =
        last + std::remainder(state.theta[j] - before[j] - last, 2 * std::numbers::pi);
    state.theta[j] = before[j] + turn;
    last = turn;
  }
}

Eigen::Matrix3Xd directors(const der::RodState& state) {
  Eigen::Matrix3Xd m1(3, state.theta.size());
  for (int j = 0; j < state.theta.size(); ++j) m1.col(j) = der::material_frame(state, j).col(0);
  return m1;
}

}  // namespace tencer::model
