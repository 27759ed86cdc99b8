// The first network without an equilibrium solve: cables in tension that balance the rods' forces
// where the target is, found as one convex problem.
#pragma once

#include <span>
#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/network.hpp>
#include <tencer/symmetry/group.hpp>

namespace tencer::sparsify {

struct BalanceOptions {
  // Ends when the forces left would move no vertex by more than this, in % of the target's
  // bounding-box diagonal.
  double percent = 0.1;
};

// Chooses tensions tau >= 0 of the candidates that minimise |M^-1 (A tau - f)|^2: f are the forces
// of rods and loads at the target, column c of A what a unit of tension in candidate c does to the
// vertices, and M the rods' Hessian with just enough mass to be positive, so that the mismatch is
// measured by how far it would move the rods. Candidates without tension are left out. When the
// network is not stable there with cables that hardly stretch, those that resist its unstable
// motions most are added. The result's state is the equilibrium found from bare.state, in which the
// rods are at the target. `symmetry`: null, or a group of the structure and the target; candidates
// then come with their images, and share their tension.
StageResult balance(const Network& bare, const sensitivity::Target& target,
                    std::span<const springs::Cable> candidates, const symmetry::Group* symmetry,
                    const BalanceOptions& options = {}, const Control& control = {});

}  // namespace tencer::sparsify
