// The eigenvalues nearest to zero from below in the spectrum of an inverse: shift-invert Lanczos.
#pragma once

#include <functional>
#include <tencer/linalg/eigenpairs.hpp>

namespace tencer::linalg {

// The operator out = A^-1 in (symmetric, on vectors of length n); modes that must not count are
// projected out by the operator itself.
using InverseOperator = std::function<void(const double* in, double* out)>;

// The `count` smallest eigenvalues of a positive semidefinite A, through the largest of A^-1
// (Spectra, Lanczos with implicit restarts). converged is false when the iteration limit was
// reached, and values and vectors then hold what was found, or when the operator gave zeros or
// numbers that are not finite, and they are empty. tolerance: relative, of an eigenvalue. Throws
// std::invalid_argument unless n > count >= 1, and what the operator throws.
Eigenpairs lowest_eigenpairs(const InverseOperator& inverse, int n, int count,
                             double tolerance = 1e-8);

}  // namespace tencer::linalg
