#include "sparse_ldlt.hpp"

#include <new>
#include <vector>

#include "significant_pivot.hpp"

namespace tencer::linalg {
namespace {

cholmod_sparse view_of(const SymmetricMatrix& matrix) {
  cholmod_sparse view{};
  view.nrow = static_cast<std::size_t>(matrix.rows());
  view.ncol = static_cast<std::size_t>(matrix.cols());
  view.nzmax = static_cast<std::size_t>(matrix.nonZeros());
  view.p = const_cast<int*>(matrix.outerIndexPtr());
  view.i = const_cast<int*>(matrix.innerIndexPtr());
  view.x = const_cast<double*>(matrix.valuePtr());
  view.stype = -1;  // lower triangle
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

cholmod_dense view_of(const double* values, Eigen::Index rows, Eigen::Index columns) {
  cholmod_dense view{};
  view.nrow = static_cast<std::size_t>(rows);
  view.ncol = static_cast<std::size_t>(columns);
  view.nzmax = view.nrow * view.ncol;
  view.d = view.nrow;
  view.x = const_cast<double*>(values);
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

}  // namespace

SparseLdlt::SparseLdlt() {
  cholmod_start(&common_);
  // Supernodal factors are L L^T: they fail on indefinite matrices and have no inertia.
  common_.supernodal = CHOLMOD_SIMPLICIAL;
  common_.final_ll = 0;
  common_.print = 0;
  common_.nmethods = 1;
  common_.method[0].ordering = CHOLMOD_AMD;
  common_.postorder = 1;
}

SparseLdlt::~SparseLdlt() {
  cholmod_free_dense(&solution_, &common_);
  cholmod_free_dense(&workspace_y_, &common_);
  cholmod_free_dense(&workspace_e_, &common_);
  cholmod_free_factor(&factor_, &common_);
  cholmod_finish(&common_);
}

void SparseLdlt::require_memory() const {
  if (common_.status == CHOLMOD_OUT_OF_MEMORY || common_.status == CHOLMOD_TOO_LARGE)
    throw std::bad_alloc();
}

void SparseLdlt::analyse(const SymmetricMatrix& matrix) {
  cholmod_free_factor(&factor_, &common_);
  cholmod_sparse view = view_of(matrix);
  factor_ = cholmod_analyze(&view, &common_);
  require_memory();
}

double SparseLdlt::pivot(int j) const {
  return static_cast<const double*>(factor_->x)[static_cast<const int*>(factor_->p)[j]];
}

bool SparseLdlt::factorise(const SymmetricMatrix& matrix, double shift) {
  cholmod_sparse view = view_of(matrix);
  double beta[2] = {shift, 0.0};
  cholmod_factorize_p(&view, beta, nullptr, 0, factor_, &common_);
  require_memory();
  return factor_->xtype == CHOLMOD_REAL && factor_->minor == factor_->n && pivots_are_significant();
}

bool SparseLdlt::pivots_are_significant() const {
  const int* begin = static_cast<const int*>(factor_->p);
  const int* count = static_cast<const int*>(factor_->nz);
  const int* row = static_cast<const int*>(factor_->i);
  const double* l = static_cast<const double*>(factor_->x);
  std::vector<double> subtracted(factor_->n, 0.0);
  for (int k = 0; k < size(); ++k) {
    const double magnitude = std::abs(pivot(k));
    if (!is_significant_pivot(magnitude, subtracted[k])) return false;
    for (int s = begin[k] + 1; s < begin[k] + count[k]; ++s)
      subtracted[row[s]] += l[s] * l[s] * magnitude;
  }
  return true;
}

Inertia SparseLdlt::inertia() const {
  Inertia inertia;
  for (int j = 0; j < size(); ++j) ++(pivot(j) < 0.0 ? inertia.negative : inertia.positive);
  return inertia;
}

Eigen::MatrixXd SparseLdlt::solve(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides) const {
  const Eigen::MatrixXd packed = right_hand_sides;
  const std::scoped_lock lock(solving_);
  cholmod_dense view = view_of(packed.data(), packed.rows(), packed.cols());
  cholmod_dense* x = cholmod_solve(CHOLMOD_A, factor_, &view, &common_);
  require_memory();
  const Eigen::MatrixXd solution =
      Eigen::Map<const Eigen::MatrixXd>(static_cast<double*>(x->x), packed.rows(), packed.cols());
  cholmod_free_dense(&x, &common_);
  return solution;
}

void SparseLdlt::solve(const Eigen::VectorXd& right_hand_side, Eigen::VectorXd& solution) const {
  const std::scoped_lock lock(solving_);
  cholmod_dense view = view_of(right_hand_side.data(), right_hand_side.size(), 1);
  cholmod_solve2(CHOLMOD_A, factor_, &view, nullptr, &solution_, nullptr, &workspace_y_,
                 &workspace_e_, &common_);
  require_memory();
  solution = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(solution_->x),
                                               right_hand_side.size());
}

Eigen::VectorXd SparseLdlt::negative_curvature() const {
  int lowest = 0;
  for (int j = 1; j < size(); ++j)
    if (pivot(j) < pivot(lowest)) lowest = j;
  if (pivot(lowest) >= 0.0) return {};
  // With P A P^T = L D L^T and L^T P d = e_j, d^T A d = D_jj.
  const Eigen::VectorXd unit = Eigen::VectorXd::Unit(size(), lowest);
  const std::scoped_lock lock(solving_);
  cholmod_dense view = view_of(unit.data(), unit.size(), 1);
  cholmod_dense* permuted = cholmod_solve(CHOLMOD_Lt, factor_, &view, &common_);
  require_memory();
  cholmod_dense* direction = cholmod_solve(CHOLMOD_Pt, factor_, permuted, &common_);
  if (!direction) cholmod_free_dense(&permuted, &common_);
  require_memory();
  const Eigen::VectorXd result =
      Eigen::Map<const Eigen::VectorXd>(static_cast<double*>(direction->x), size());
  cholmod_free_dense(&permuted, &common_);
  cholmod_free_dense(&direction, &common_);
  return result;
}

}  // namespace tencer::linalg
