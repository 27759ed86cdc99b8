#include <algorithm>
#include <tencer/core/error.hpp>
#include <tencer/linalg/symmetric_factor.hpp>

#include "dense_ldlt.hpp"
#include "sparse_ldlt.hpp"

namespace tencer::linalg {
namespace {

// Sparse operations are slower: between 60 and 600 unknowns both take the same time when the sparse
// factorisation needs 0.42 to 0.5 of the operations of the dense one (measured; a full matrix of
// 600 takes 25 ms sparse and 8 ms dense, one of 300 takes 3.2 and 1.0).
constexpr double dense_from = 0.45;

}  // namespace

// The sparse analysis is always made: it tells how far the pattern fills up, which decides who
// factorises.
struct SymmetricFactor::Implementation {
  SparseLdlt sparse;
  DenseLdlt dense;
  Eigen::VectorXi analysed_columns, analysed_rows;  // the pattern behind `sparse`
  bool is_dense = false;
  bool usable = false;
  int analyses = 0;
  int factorisations = 0;

  int size() const { return std::max(0, static_cast<int>(analysed_columns.size()) - 1); }

  bool same_pattern(const SymmetricMatrix& matrix) const {
    return analysed_columns.size() == matrix.cols() + 1 &&
           analysed_rows.size() == matrix.nonZeros() &&
           std::equal(analysed_columns.begin(), analysed_columns.end(), matrix.outerIndexPtr()) &&
           std::equal(analysed_rows.begin(), analysed_rows.end(), matrix.innerIndexPtr());
  }

  void analyse(const SymmetricMatrix& matrix) {
    analysed_columns.resize(0);
    sparse.analyse(matrix);
    is_dense = sparse.operations() > dense_from * DenseLdlt::operations(matrix.rows());
    analysed_columns = Eigen::Map<const Eigen::VectorXi>(matrix.outerIndexPtr(), matrix.cols() + 1);
    analysed_rows = Eigen::Map<const Eigen::VectorXi>(matrix.innerIndexPtr(), matrix.nonZeros());
    ++analyses;
  }
};

SymmetricFactor::SymmetricFactor() : implementation_(std::make_unique<Implementation>()) {}
SymmetricFactor::~SymmetricFactor() = default;
SymmetricFactor::SymmetricFactor(SymmetricFactor&&) noexcept = default;
SymmetricFactor& SymmetricFactor::operator=(SymmetricFactor&&) noexcept = default;

bool SymmetricFactor::factorise(const SymmetricMatrix& matrix, double shift) {
  core::require(matrix.rows() == matrix.cols() && matrix.isCompressed(),
                "factorise: needs a square compressed matrix");
  auto& self = *implementation_;
  self.usable = false;
  if (!self.same_pattern(matrix)) self.analyse(matrix);
  ++self.factorisations;
  self.usable =
      self.is_dense ? self.dense.factorise(matrix, shift) : self.sparse.factorise(matrix, shift);
  return self.usable;
}

Inertia SymmetricFactor::inertia() const {
  const auto& self = *implementation_;
  if (!self.usable) return {.zero = 1};
  return self.is_dense ? self.dense.inertia() : self.sparse.inertia();
}

Eigen::MatrixXd SymmetricFactor::solve(
    const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides) const {
  const auto& self = *implementation_;
  core::require(self.usable && right_hand_sides.rows() == self.size(),
                "solve: needs a factorised matrix of the same size");
  if (right_hand_sides.cols() == 0) return right_hand_sides;  // which CHOLMOD and Eigen mistake
  return self.is_dense ? self.dense.solve(right_hand_sides) : self.sparse.solve(right_hand_sides);
}

void SymmetricFactor::solve(const Eigen::VectorXd& right_hand_side,
                            Eigen::VectorXd& solution) const {
  const auto& self = *implementation_;
  core::require(self.usable && right_hand_side.size() == self.size(),
                "solve: needs a factorised matrix of the same size");
  if (self.is_dense)
    solution = self.dense.solve(right_hand_side);
  else
    self.sparse.solve(right_hand_side, solution);
}

Eigen::VectorXd SymmetricFactor::negative_curvature() const {
  const auto& self = *implementation_;
  core::require(self.usable, "negative_curvature: needs a factorised matrix");
  return self.is_dense ? self.dense.negative_curvature() : self.sparse.negative_curvature();
}

FactorCost SymmetricFactor::cost() const {
  const auto& self = *implementation_;
  core::require(self.size() > 0, "cost: needs a factorised matrix");
  const double size = self.size();
  if (self.is_dense)
    return {.operations = DenseLdlt::operations(self.size()),
            .bytes = size * size * sizeof(double)};
  // Simplicial: a value and a row index an entry.
  return {.operations = self.sparse.operations(),
          .bytes = self.sparse.entries() * (sizeof(double) + sizeof(int))};
}

int SymmetricFactor::analyses() const { return implementation_->analyses; }
int SymmetricFactor::factorisations() const { return implementation_->factorisations; }

}  // namespace tencer::linalg
