// Which variables a network's cables have in an outer optimization, scaled to comparable size.
#pragma once

#include <vector>

#include "design_problem.hpp"
#include "refine.hpp"

namespace tencer::sparsify {

// The sparsity weight of a cable.
double weight_of(const springs::Cable& cable, const RefineSetup& setup);

// `network` has been rebased to rho.
std::vector<Variable> design_variables(const Network& network, const RefineSetup& setup,
                                       double rho);

}  // namespace tencer::sparsify
