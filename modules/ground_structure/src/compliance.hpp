// How far forces move the rods at the target: the metric in which mismatches of forces are told.
#pragma once

#include <optional>
#include <tencer/equilibrium/system.hpp>
#include <tencer/linalg/symmetric_factor.hpp>

namespace tencer::ground_structure {

// The rods' Hessian at `state` made positive definite by the smallest mass that does so, from that
// of a free rod's softest motion on; factorised. none: no mass does, say because the Hessian is not
// finite.
std::optional<linalg::SymmetricFactor> compliance(const equilibrium::System& system,
                                                  const model::State& state);

}  // namespace tencer::ground_structure
