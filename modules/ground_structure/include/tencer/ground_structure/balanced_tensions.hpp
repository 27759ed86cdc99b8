// The balance of forces at the target as a nonnegative least-squares problem over the candidates.
//
// A mismatch of forces is measured by how far it would move the rods: the metric is the inverse of
// the rods' Hessian at the target, made positive definite by the smallest mass that does so, from
// that of a free rod's softest motion on. Axial force in a stiff rod then costs nothing, as it
// should.
#pragma once

#include <optional>
#include <tencer/ground_structure/candidate_columns.hpp>
#include <tencer/linalg/nonnegative.hpp>
#include <vector>

namespace tencer::ground_structure {

// `bare`, here and below: the rods, with those cables that stay as they are.
//
// How far each unit of tension moves the positions (size x orbits), and how far the forces of
// `bare` would, the other way (size): what the columns are to add up to. Unknowns that are no
// positions are zero.
struct Displacements {
  Eigen::MatrixXd columns{};
  Eigen::VectorXd goal{};
};

// none: the rods' Hessian at `state` is not finite.
[[nodiscard]] std::optional<Displacements> displacements(const equilibrium::System& bare,
                                                         const model::State& state,
                                                         const std::vector<CandidateOrbit>& orbits);

// Tensions of the orbits, most of them zero, at which the forces left over move no vertex by more
// than `accuracy` (a length), or as little as they can. none: as above.
[[nodiscard]] std::optional<linalg::Nonnegative> balanced_tensions(
    const equilibrium::System& bare, const model::State& state,
    const std::vector<CandidateOrbit>& orbits, double accuracy);

}  // namespace tencer::ground_structure
