// Candidates as columns of the balance of forces: what a unit of tension in each does to the rods.
#pragma once

#include <Eigen/Core>
#include <span>
#include <tencer/equilibrium/system.hpp>
#include <tencer/symmetry/group.hpp>
#include <vector>

namespace tencer::ground_structure {

// A candidate at a state of the rods.
struct CandidateColumn {
  springs::Cable cable{};
  springs::Stencil stencil{};
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // from end a to end b, of length 1
  double length = 0.0;
};

// A candidate with its images under a symmetry group: they share their tension.
using CandidateOrbit = std::vector<CandidateColumn>;

// Each candidate with its images, and of those that are images of each other only one. symmetry:
// null for none.
std::vector<CandidateOrbit> candidate_orbits(const equilibrium::System& system,
                                             const model::State& state,
                                             std::span<const springs::Cable> candidates,
                                             const symmetry::Group* symmetry);

// Calls visit(unknown, weight) for the free unknowns that a unit of tension acts on.
template <class Visit>
void for_each_unknown(const equilibrium::System& system, const CandidateColumn& column,
                      Visit&& visit) {
  system.for_each_unknown(column.stencil, [&](int unknown, int axis, double weight) {
    visit(unknown, weight * column.direction[axis]);
  });
}

// The orbit's cables, each pulling with `tension` and a rest length of rest_ratio times its length.
std::vector<springs::Cable> cables_of(const CandidateOrbit& orbit, double tension,
                                      double rest_ratio);

}  // namespace tencer::ground_structure
