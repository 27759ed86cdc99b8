// The same design with finer rods, to see what the number of vertices does to its pose.
#pragma once

#include <tencer/model/design.hpp>

namespace tencer::model {

// Every edge of every rod divided into `times` edges of equal length at rest; vertex i becomes
// vertex i * times. Targets and poses follow cubic curves through the old vertices; sections, bends
// at rest per length, cables by arc length, supports and loads stay. An edge held at both ends
// along an axis is held all along; a clamp, which a coarse rod feels in the middle of such an edge,
// thereby moves by up to half an edge, and results with it change in first order, not in second.
// What was found out about the design (errors, certificate, trace) is copied. Throws
// std::invalid_argument unless times >= 1.
Design subdivided(const Design& design, int times);

}  // namespace tencer::model
