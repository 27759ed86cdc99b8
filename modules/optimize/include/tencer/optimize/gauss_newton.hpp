// A bounded Levenberg-Marquardt method: for sums of squares and whatever else brings a Hessian that
// is, or nearly is, positive semidefinite. Needs no other package, so every build has it, and its
// runs in different threads know nothing of each other.
#pragma once

#include <tencer/optimize/backend.hpp>

namespace tencer::optimize {

// "gauss-newton". Steps of (H + damping diag |H|) on the parameters that no bound holds back, cut
// off at the bounds, so that active bounds are reached exactly; the damping grows until the value
// falls (Marquardt 1963; Bertsekas 1982 for the bounds). H comes from Problem::hessian whatever
// Options::curvature says; minimise throws std::invalid_argument without it. An indefinite H is
// damped until it is not.
Backend gauss_newton();

}  // namespace tencer::optimize
