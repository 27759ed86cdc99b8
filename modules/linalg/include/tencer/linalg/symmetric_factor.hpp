// L D L^T of a sparse symmetric matrix, its inertia and its solves. The symbolic analysis is kept
// while the pattern stays the same; a pattern that would fill up is factorised densely.
#pragma once

#include <memory>
#include <tencer/linalg/symmetric_assembler.hpp>

namespace tencer::linalg {

struct Inertia {
  int negative = 0;
  int zero = 0;  // 1 when the factorisation met a pivot not distinguishable from zero
  int positive = 0;
};

// What one factorisation takes at least: multiplications and additions, and the size of L.
struct FactorCost {
  double operations = 0.0;
  double bytes = 0.0;
};

// Const functions may be called from several threads at once, and solve the same to the last bit as
// from one; sparse solves with one factor then wait for each other. Throws std::bad_alloc where
// memory runs out.
class SymmetricFactor {
 public:
  SymmetricFactor();
  ~SymmetricFactor();
  SymmetricFactor(SymmetricFactor&&) noexcept;
  SymmetricFactor& operator=(SymmetricFactor&&) noexcept;

  // Factorises `matrix` (lower triangle) + shift * identity. Returns false when a pivot is lost
  // in rounding or the matrix is not finite; then inertia().zero > 0 and solve must not be called.
  // Throws std::invalid_argument for a matrix that is not square and compressed.
  [[nodiscard]] bool factorise(const SymmetricMatrix& matrix, double shift = 0.0);

  // Signs of D: by Sylvester's law the signs of the matrix's eigenvalues.
  Inertia inertia() const;

  // right_hand_sides: size x k. These and negative_curvature throw std::invalid_argument for a
  // wrong size and unless the last factorise succeeded.
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides) const;
  // The same for one right-hand side into `solution`, without allocating once warmed up.
  void solve(const Eigen::VectorXd& right_hand_side, Eigen::VectorXd& solution) const;

  // A direction d with d^T A d < 0 (the pivot's value), from one back substitution with the column
  // of the most negative pivot; empty when no pivot is negative.
  Eigen::VectorXd negative_curvature() const;

  // Of the pattern factorised last; throws std::invalid_argument when there is none.
  FactorCost cost() const;

  // How often a matrix was analysed and factorised, for reports and benchmarks.
  int analyses() const;
  int factorisations() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace tencer::linalg
