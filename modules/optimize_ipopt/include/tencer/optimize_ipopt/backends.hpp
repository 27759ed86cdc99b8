// Ipopt: an interior-point method. The bounds are kept by a barrier, so the point it returns lies
// strictly between them, within about the gradient tolerance of those that are active.
#pragma once

#include <tencer/optimize/backend.hpp>
#include <vector>

namespace tencer::optimize_ipopt {

// "ipopt". Uses Problem::hessian when Options::curvature says so, which pays from a few tens of
// parameters on. Runs in different threads wait for each other (Ipopt's linear solver is not
// thread-safe), so the problem's functions must not start another such run.
std::vector<optimize::Backend> backends();

}  // namespace tencer::optimize_ipopt
