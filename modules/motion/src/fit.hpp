// Poses of one structure compared: those that nothing holds are moved onto each other first.
#pragma once

#include <Eigen/Core>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::motion {

// Per rod, 3 x n.
using Positions = std::vector<Eigen::Matrix3Xd>;

// Where the vertices of `state` are when it is moved rigidly to fit `to`; as they are where the
// structure is held.
Positions fitted(const model::Structure& structure, const model::State& state,
                 const model::State& to);

// Largest distance of a vertex, fitted.
double distance(const model::Structure& structure, const model::State& from,
                const model::State& to);

}  // namespace tencer::motion
