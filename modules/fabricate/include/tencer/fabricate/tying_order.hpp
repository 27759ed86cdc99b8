// A suggestion in which order to tie cables.
#pragma once

#include <tencer/fabricate/cut_list.hpp>
#include <vector>

namespace tencer::fabricate {

// Every cable once. The first is at the first mark of rod A; the next always the one with an end
// nearest, along its rod, to where a cable is tied already, so that hands work their way along the
// rods; where none is on a rod that has cables, the first mark of the next rod begins anew. Nothing
// is known of the shapes between.
std::vector<int> tying_order(const CutList& list);

}  // namespace tencer::fabricate
