// Fewer cables one by one, all others refitted: what the sparsity term leaves for want of a better
// minimum (the paper's open problem of asking for a number of cables, section 6.3).
#pragma once

#include <tencer/optimize/backend.hpp>
#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/network.hpp>
#include <tencer/sparsify/outer.hpp>
#include <tencer/sparsify/rules.hpp>

namespace tencer::sparsify {

struct ThinOptions {
  double max_percent = 1.0;  // the largest distance to the target that is accepted
  int cables = 0;            // ends when so few are left
  int tries = 6;             // of different cables before it ends
  OuterOptions outer{};
};

// Takes out the cable whose loss is predicted to cost least once the others have been refitted (to
// first order), then refits stiffnesses and attachments as slide() does - first by damped
// Gauss-Newton steps, which get close in a few dozen solves, then with the optimizer chosen - again
// and again. A network that is too far from the target, or softer than
// OuterOptions::least_eigenvalue, is not accepted; then the next cable is tried. Every accepted
// network has a row in the trace. Requires an equilibrium in which every cable pulls.
StageResult thin(const Network& network, const sensitivity::Target& target, const Rules& rules,
                 const optimize::Backend& backend, const ThinOptions& options = {},
                 const Control& control = {});

}  // namespace tencer::sparsify
