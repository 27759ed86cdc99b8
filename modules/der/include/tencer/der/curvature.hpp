// How far a rod is bent.
#pragma once

#include <Eigen/Core>
#include <tencer/der/rod.hpp>

namespace tencer::der {

// Per bending vertex, 2 x bending vertices: the curvature (1 / length) towards m1 and towards m2
// beyond that at rest, in the material frame of the edge before the vertex. A rod that keeps no
// frames has its whole curvature in the first row: its section bends alike towards every side.
Eigen::Matrix2Xd bending_curvature(const Rod& rod, const RodState& state);

}  // namespace tencer::der
