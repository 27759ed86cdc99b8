// NLopt's conservative convex separable approximations: descent by gradients alone, each step the
// minimiser of a separable model between the bounds. Active bounds are reached exactly.
#pragma once

#include <tencer/optimize/backend.hpp>
#include <vector>

namespace tencer::optimize_nlopt {

// "mma" (method of moving asymptotes) and "ccsaq" (its quadratic sibling, the steadier one;
// Svanberg 2002). Neither uses Problem::hessian. The first steps reach across up to half the
// distance of the bounds, or 1 where these are infinite, unless Options::initial_step is less. Runs
// in different threads know nothing of each other.
std::vector<optimize::Backend> backends();

}  // namespace tencer::optimize_nlopt
