// The last touch to a network: as close to its target as it goes without losing stability.
#pragma once

#include "state/fitted_network.hpp"

namespace tencer::elimination {

// Distances below this, in % of the target's diagonal, are not told apart.
inline constexpr double min_distance_percent = 1e-4;

// Fits the network, which must be usable, and leaves it fitted. min_percent: the objective's unit
// of distance is never smaller.
void fit_closely(FittedNetwork& fitted, model::Measure measure, double stability_weight,
                 double min_percent, const FitOptions& options);

}  // namespace tencer::elimination
