// Bounds on a step that keep cables clear of rods and marks apart from each other.
#pragma once

#include <tencer/model/clearance.hpp>

#include "model/gauss_newton_model.hpp"
#include "model/local_model.hpp"

namespace tencer::elimination {

// Of the passes and marks that are near enough to matter, to first order. What is too near is asked
// to give way; marks nearer than half of what they should be become the same.
StepBounds gap_bounds(const sensitivity::Configuration& at, const LocalModel& local,
                      const model::Gaps& gaps);

// How much the worst pass or pair of marks falls short, in outer radii of the rod; 0: nothing does.
double missing_gap(const model::Structure& structure, const model::State& state,
                   const model::Gaps& gaps);

}  // namespace tencer::elimination
