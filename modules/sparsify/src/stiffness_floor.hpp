// Whether a structure's softest motion is stiffer than a given limit, by one factorisation.
#pragma once

#include <tencer/linalg/symmetric_factor.hpp>
#include <tencer/sensitivity/tracker.hpp>

namespace tencer::sparsify {

// Whether all eigenvalues in the sense of equilibrium::stability, apart from rigid motion, exceed
// `limit` (in its units): the inertia of H - limit M. `workspace` keeps the symbolic analysis.
bool stiffer_than(const sensitivity::Configuration& at, double limit,
                  linalg::SymmetricFactor& workspace);

}  // namespace tencer::sparsify
