// The task that a design answers, to be asked anew.
#pragma once

#include <tencer/model/design.hpp>
#include <tencer/model/scene.hpp>

namespace tencer::model {

// The scene of the design's rods, supports and loads with its target, without its cables; what was
// asked of cables is not in a design, so all of that is the default. Rods are as long as their
// targets. `standard` is the material of rods that tell none.
Scene scene_of(const Design& design, const Material& standard = glass_fibre());

}  // namespace tencer::model
