// Where the rods of a structure are.
#pragma once

#include <Eigen/Core>
#include <tencer/der/rod.hpp>
#include <tencer/model/structure.hpp>
#include <vector>

namespace tencer::model {

// One entry a rod.
using State = std::vector<der::RodState>;

// The rods with their vertices at positions[rod], 3 x n each. Throws std::invalid_argument when
// sizes do not fit.
State make_state(const Structure& structure, const std::vector<Eigen::Matrix3Xd>& positions);

// Of the vertices, per rod, 3 x n.
std::vector<Eigen::Matrix3Xd> positions_of(const State& state);

// The vector from a cable's end a to its end b at a state.
Eigen::Vector3d span_of(const springs::Stencil& stencil, const State& state);

// The points where the cables end, 3 x 2 c, those of a cable beside each other, with the rods'
// vertices at positions[rod].
Eigen::Matrix3Xd cable_ends(const Structure& structure,
                            const std::vector<Eigen::Matrix3Xd>& positions);

// Of every cable at a state, from end to end.
Eigen::VectorXd cable_lengths(const Structure& structure, const State& state);

}  // namespace tencer::model
