// Where the rods of a design file are, as solvers start from it.
#pragma once

#include <tencer/model/design.hpp>
#include <tencer/model/scaling.hpp>
#include <tencer/model/state.hpp>

namespace tencer::pipeline {

// The rods of `structure`, the design's scaled, at the design's target, and moved on from there to
// its pose. Material frames are the design's; where it has none at the target, those that cost
// least there.
model::State target_state(const model::Design& design, const model::Structure& structure,
                          const model::Scaling& scaling);
model::State pose_state(const model::Design& design, const model::Structure& structure,
                        const model::Scaling& scaling);

}  // namespace tencer::pipeline
