// Material frames in balance on given vertices.
#pragma once

#include <tencer/model/state.hpp>

namespace tencer::equilibrium {

// Lets the frames of all rods that have any turn until the twisting moments balance, the vertices
// held where they are: cables can balance forces on vertices, but no such moments.
void relax_frames(const model::Structure& structure, model::State& state);

}  // namespace tencer::equilibrium
