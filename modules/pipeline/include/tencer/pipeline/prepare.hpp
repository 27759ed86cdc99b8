// From a scene to the problem that is solved.
#pragma once

#include <tencer/core/error.hpp>
#include <tencer/ground_structure/problem.hpp>
#include <tencer/model/scaling.hpp>
#include <tencer/model/scene.hpp>

namespace tencer::pipeline {

struct Prepared {
  model::Scaling scaling{};
  // Scaled, with all candidates that the rules allow. Its rods start at the target, with material
  // frames that carry no moments which cables would have to balance. It has a symmetry when the
  // scene asks for one, the method can keep it, and it is more than the identity.
  ground_structure::Problem problem{};
};

// Errors name the scene's source or its key: rules that allow no cable, a rod whose vertices meet,
// edges of a rod that differ by more than 1 : 1000, a rod thicker than its bends are wide, an
// anchor on a rod, anchors that do not enclose the target, loads that nothing holds, a symmetry
// that is not there.
core::Expected<Prepared> prepare(const model::Scene& scene);

// The same problem once its pins are replaced by cables, with the candidates there are then.
core::Expected<ground_structure::Problem> without_pins(const model::Scene& scene,
                                                       const ground_structure::Problem& pinned);

}  // namespace tencer::pipeline
