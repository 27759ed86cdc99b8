#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <exception>
#include <tencer/core/error.hpp>
#include <tencer/linalg/lowest_eigenpairs.hpp>

namespace tencer::linalg {
namespace {

// Spectra's operator concept. Remembers whether an exception on its way through Spectra is the
// operator's own.
struct Operator {
  using Scalar = double;
  const InverseOperator& apply;
  Eigen::Index n;
  Eigen::Index rows() const { return n; }
  Eigen::Index cols() const { return n; }
  mutable bool threw = false;
  void perform_op(const double* in, double* out) const {
    threw = true;
    apply(in, out);
    threw = false;
  }
};

}  // namespace

Eigenpairs lowest_eigenpairs(const InverseOperator& inverse, int n, int count, double tolerance) {
  core::require(count >= 1 && count < n, "lowest_eigenpairs: needs 1 <= count < n");
  Operator op{inverse, n};
  const int subspace = std::min(n, std::max(2 * count + 1, 20));
  Spectra::SymEigsSolver<Operator> solver(op, count, subspace);
  try {
    solver.init();
    solver.compute(Spectra::SortRule::LargestAlge, 1000, tolerance, Spectra::SortRule::LargestAlge);
  } catch (const std::exception&) {
    // Spectra throws where the operator gives zeros or numbers that are not finite.
    if (op.threw) throw;
    return {};
  }
  const Eigen::VectorXd inverse_values = solver.eigenvalues();
  Eigenpairs pairs;
  pairs.converged = solver.info() == Spectra::CompInfo::Successful;
  pairs.values = inverse_values.cwiseInverse();
  pairs.vectors = solver.eigenvectors();
  return pairs;
}

}  // namespace tencer::linalg
