// The cables that a design may choose from: the ground structure (paper section 5.1).
#pragma once

#include <tencer/core/error.hpp>
#include <tencer/model/rules.hpp>
#include <vector>

namespace tencer::ground_structure {

// All cables between vertices of the rods, and from vertices to anchors, that the rules allow at
// `positions` (3 x n per rod), with stiffness and rest length 0. Of a rod with more than 400
// vertices (or of all with more than 1500) only every so many count, evenly. Left out as useless:
// cables between neighbours on a rod, and between vertices that supports hold, and, where the rules
// have gaps, those that rods are in the way of; these may be all, as along a straight rod.
//
// Errors: no cable is allowed; two vertices, or a vertex and an anchor, that an allowed cable would
// join coincide, say because a rod crosses itself. Throws std::invalid_argument when rules or
// positions do not fit the structure.
core::Expected<std::vector<springs::Cable>> candidates(
    const model::Structure& structure, const std::vector<Eigen::Matrix3Xd>& positions,
    const model::Rules& rules);

}  // namespace tencer::ground_structure
