// The first network without an equilibrium solve: cables in tension that balance the rods' forces
// where the target is, found as one convex problem.
#pragma once

#include <tencer/ground_structure/problem.hpp>
#include <tencer/network/stage.hpp>

namespace tencer::ground_structure {

struct ForceBalanceOptions {
  // The balance ends when the forces left over would move no vertex by more than this, in % of the
  // target's bounding-box diagonal.
  double max_error_percent = 0.1;
  // Cables are added until the network is this stable at the target (in the units of
  // equilibrium::Stability): ten times a free straight rod, since it gets softer as it settles.
  double stability_margin = 5000;
  int max_added = 40;  // of these cables, orbits counted once
  // Their tension, relative to the mean of the others: enough to pull, too little to move the rods.
  double added_tension = 0.1;
  // Rods that the balance leaves free to move at no cost are tied first, each group with so many
  // cables of this tension (EI / L^2); seven hold a body in space that can only be pulled at.
  int ties = 7;
  double tie_tension = 1.0;

  // Throws std::invalid_argument, naming the field, unless all are positive.
  void validate() const;
};

// Chooses tensions tau >= 0 of the candidates that minimise |M^-1 (A tau - f)|^2: f are the forces
// of rods and loads at the target, column c of A what a unit of tension in candidate c does to the
// vertices, and M the metric of balanced_tensions.hpp. Candidates without tension are left out.
// When the network is not stable there with cables that hardly stretch, those that resist its
// unstable motions most are added. Where no such network holds the rods near the target, those
// cables are taken that pull where the rods rest with all candidates tied (feasibility.hpp),
// without symmetry. The result's state is the equilibrium found from problem.start. Cables that
// problem.structure has come first in the result and stay as they are.
//
// symmetry: null, or a group of the structure and the target (problem.symmetry or another);
// candidates then come with their images, and share their tension. Throws std::invalid_argument for
// wrong options.
network::StageResult force_balance(const Problem& problem, const symmetry::Group* symmetry,
                                   const ForceBalanceOptions& options = {},
                                   const network::Control& control = {});

}  // namespace tencer::ground_structure
