#include <tencer/core/error.hpp>
#include <tencer/sensitivity/parameters.hpp>
#include <tencer/sensitivity/pose_map.hpp>

#include "rigid_free_solve.hpp"

namespace tencer::sensitivity {
namespace {

// Calls visit(rod, vertex, axis, unknown) for all positions that are free.
template <class Visit>
void for_each_position(const equilibrium::System& system, Visit&& visit) {
  const auto& rods = system.structure().rods;
  for (int r = 0; r < static_cast<int>(rods.size()); ++r)
    for (int vertex = 0; vertex < rods[r].vertices(); ++vertex)
      for (int axis = 0; axis < 3; ++axis)
        if (const int unknown = system.position_index(r, vertex, axis); unknown >= 0)
          visit(r, vertex, axis, unknown);
}

}  // namespace

Eigen::VectorXd pull_back(const Configuration& at, std::span<const springs::Parameter> parameters,
                          const std::vector<Eigen::Matrix3Xd>& gradient) {
  core::require(gradient.size() == at.state.size(), "pull_back: needs a gradient for every rod");
  for (std::size_t r = 0; r < gradient.size(); ++r)
    core::require(gradient[r].cols() == at.state[r].x.cols(),
                  "pull_back: needs a column of the gradient for every vertex");
  Eigen::VectorXd force = Eigen::VectorXd::Zero(at.system.size());
  for_each_position(at.system, [&](int rod, int vertex, int axis, int unknown) {
    force[unknown] = -gradient[rod](axis, vertex);
  });
  return force_derivatives_transposed(at.system, at.state, parameters, rigid_free_solve(at, force));
}

std::vector<Eigen::Matrix3Xd> push_forward(const Configuration& at,
                                           std::span<const springs::Parameter> parameters,
                                           const Eigen::VectorXd& change) {
  core::require(change.size() == static_cast<Eigen::Index>(parameters.size()),
                "push_forward: needs a change for every parameter");
  const Eigen::VectorXd motion =
      rigid_free_solve(at, -(force_derivatives(at.system, at.state, parameters) * change));
  std::vector<Eigen::Matrix3Xd> motions;
  for (const der::RodState& rod : at.state)
    motions.push_back(Eigen::Matrix3Xd::Zero(3, rod.x.cols()));
  for_each_position(at.system, [&](int rod, int vertex, int axis, int unknown) {
    motions[rod](axis, vertex) = motion[unknown];
  });
  return motions;
}

}  // namespace tencer::sensitivity
