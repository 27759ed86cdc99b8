// A bounded Levenberg method for sums of squares, small enough to refit after every cable that is
// taken out, whatever optimizer the user chose.
#pragma once

#include <tencer/optimize/backend.hpp>

namespace tencer::sparsify {

// Steps of (H + damping diag H) on the variables that no bound holds back, cut off at the bounds;
// needs Problem::hessian.
optimize::Backend levenberg();

}  // namespace tencer::sparsify
