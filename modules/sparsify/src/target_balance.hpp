// The balance of forces at the target as a nonnegative least-squares problem (see balance.hpp).
#pragma once

#include <span>
#include <tencer/equilibrium/system.hpp>
#include <tencer/linalg/nonnegative.hpp>
#include <tencer/linalg/symmetric_factor.hpp>
#include <tencer/symmetry/group.hpp>
#include <vector>

namespace tencer::sparsify {

// A candidate at the target, or several that share their tension.
struct Pull {
  springs::Cable cable{};
  springs::Stencil stencil{};
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  double length = 0.0;
};
using Pulls = std::vector<Pull>;

// The candidates, each with its images; of those that are images of each other only one.
std::vector<Pulls> pulls_at(const equilibrium::System& system, const equilibrium::State& state,
                            std::span<const springs::Cable> candidates,
                            const symmetry::Group* symmetry);

// The pull's cable with this tension; rho: its rest length relative to its length.
springs::Cable cable_of(const Pull& pull, double tension, double rho);

// Calls visit(unknown, weight) for the unknowns that a unit of tension acts on.
template <class Visit>
void for_each_unknown(const equilibrium::System& system, const Pull& pull, Visit&& visit) {
  for (int i = 0; i < pull.stencil.count; ++i) {
    const auto& share = pull.stencil.shares[i];
    for (int axis = 0; axis < 3; ++axis)
      if (const int at = system.position_index(share.rod, share.vertex, axis); at >= 0)
        visit(at, share.weight * pull.direction[axis]);
  }
}

// How far each unit of tension moves the positions, one column a candidate, and how far the rods'
// own forces would, the other way: what `columns` are to add up to. Measured with the rods' Hessian
// made positive definite by mass; other unknowns are zero.
struct Displacements {
  Eigen::MatrixXd columns{};
  Eigen::VectorXd goal{};
};
Displacements displacements(const equilibrium::System& bare, const equilibrium::State& state,
                            const std::vector<Pulls>& pulls);

// Tensions of `pulls` at which the forces left move no vertex by more than `accuracy` (a length),
// or as little as they can.
linalg::Nonnegative balance_forces(const equilibrium::System& bare, const equilibrium::State& state,
                                   const std::vector<Pulls>& pulls, double accuracy);

}  // namespace tencer::sparsify
