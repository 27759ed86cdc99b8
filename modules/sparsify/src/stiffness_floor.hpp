// Whether a structure's softest motion is stiffer than a given limit, by one factorisation.
#pragma once

#include <tencer/sensitivity/tracker.hpp>

namespace tencer::sparsify {

// Whether all eigenvalues in the sense of equilibrium::stability, apart from rigid motion, exceed
// `limit` (in its units): the inertia of H - limit M.
bool stiffer_than(const sensitivity::Configuration& at, double limit);

}  // namespace tencer::sparsify
