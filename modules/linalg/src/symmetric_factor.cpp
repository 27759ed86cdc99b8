#include <tencer/core/error.hpp>
#include <tencer/linalg/symmetric_factor.hpp>

#include <cholmod.h>

#include <cmath>
#include <utility>

namespace tencer::linalg {

// One cholmod_common each: it is neither shareable between threads nor copyable.
struct SymmetricFactor::Implementation {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense* solution = nullptr;     // kept between solves
  cholmod_dense* workspace_y = nullptr;  // the same
  cholmod_dense* workspace_e = nullptr;
  Eigen::VectorXi analysed_columns, analysed_rows;  // the pattern behind `factor`
  int analyses = 0;
  int factorisations = 0;
  bool usable = false;

  Implementation() {
    cholmod_start(&common);
    // Supernodal factors are L L^T: they fail on indefinite matrices and have no inertia.
    common.supernodal = CHOLMOD_SIMPLICIAL;
    common.final_ll = 0;
    common.print = 0;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
    common.postorder = 1;
  }
  ~Implementation() {
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&workspace_y, &common);
    cholmod_free_dense(&workspace_e, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  int size() const { return static_cast<int>(factor->n); }
  double pivot(int j) const {
    return static_cast<const double*>(factor->x)[static_cast<const int*>(factor->p)[j]];
  }
  bool same_pattern(const SymmetricMatrix& matrix) const {
    return factor != nullptr && analysed_columns.size() == matrix.cols() + 1 &&
           analysed_rows.size() == matrix.nonZeros() &&
           std::equal(analysed_columns.begin(), analysed_columns.end(), matrix.outerIndexPtr()) &&
           std::equal(analysed_rows.begin(), analysed_rows.end(), matrix.innerIndexPtr());
  }
  void analyse(const SymmetricMatrix& matrix, cholmod_sparse& view) {
    cholmod_free_factor(&factor, &common);
    factor = cholmod_analyze(&view, &common);
    analysed_columns =
        Eigen::Map<const Eigen::VectorXi>(matrix.outerIndexPtr(), matrix.cols() + 1);
    analysed_rows = Eigen::Map<const Eigen::VectorXi>(matrix.innerIndexPtr(), matrix.nonZeros());
    ++analyses;
  }
};

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

SymmetricFactor::SymmetricFactor() : implementation_(std::make_unique<Implementation>()) {}
SymmetricFactor::~SymmetricFactor() = default;
SymmetricFactor::SymmetricFactor(SymmetricFactor&&) noexcept = default;
SymmetricFactor& SymmetricFactor::operator=(SymmetricFactor&&) noexcept = default;

bool SymmetricFactor::factorise(const SymmetricMatrix& matrix, double shift) {
  core::require(matrix.rows() == matrix.cols() && matrix.isCompressed(),
                "factorise: needs a square compressed matrix");
  auto& self = *implementation_;
  self.usable = false;
  cholmod_sparse view = view_of(matrix);
  if (!self.same_pattern(matrix)) self.analyse(matrix, view);
  if (self.factor == nullptr) return false;
  double beta[2] = {shift, 0.0};
  cholmod_factorize_p(&view, beta, nullptr, 0, self.factor, &self.common);
  ++self.factorisations;
  self.usable = self.factor->minor == self.factor->n;
  for (int j = 0; self.usable && j < self.size(); ++j)
    self.usable = std::isfinite(self.pivot(j)) && self.pivot(j) != 0.0;
  return self.usable;
}

Inertia SymmetricFactor::inertia() const {
  const auto& self = *implementation_;
  Inertia inertia;
  if (self.factor == nullptr) return inertia;
  if (!self.usable) {
    inertia.zero = 1;
    return inertia;
  }
  for (int j = 0; j < self.size(); ++j) ++(self.pivot(j) < 0.0 ? inertia.negative : inertia.positive);
  return inertia;
}

Eigen::MatrixXd SymmetricFactor::solve(
    const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides) const {
  auto& self = *implementation_;
  core::require(self.usable && right_hand_sides.rows() == self.size(),
                "solve: needs a factorised matrix of the same size");
  const Eigen::MatrixXd packed = right_hand_sides;
  cholmod_dense view = view_of(packed.data(), packed.rows(), packed.cols());
  cholmod_dense* x = cholmod_solve(CHOLMOD_A, self.factor, &view, &self.common);
  const Eigen::MatrixXd solution =
      Eigen::Map<const Eigen::MatrixXd>(static_cast<double*>(x->x), packed.rows(), packed.cols());
  cholmod_free_dense(&x, &self.common);
  return solution;
}

void SymmetricFactor::solve(const Eigen::VectorXd& right_hand_side,
                            Eigen::VectorXd& solution) const {
  auto& self = *implementation_;
  core::require(self.usable && right_hand_side.size() == self.size(),
                "solve: needs a factorised matrix of the same size");
  cholmod_dense view = view_of(right_hand_side.data(), right_hand_side.size(), 1);
  cholmod_solve2(CHOLMOD_A, self.factor, &view, nullptr, &self.solution, nullptr,
                 &self.workspace_y, &self.workspace_e, &self.common);
  solution = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(self.solution->x),
                                               right_hand_side.size());
}

Eigen::VectorXd SymmetricFactor::negative_curvature() const {
  auto& self = *implementation_;
  core::require(self.usable, "negative_curvature: needs a factorised matrix");
  int lowest = 0;
  for (int j = 1; j < self.size(); ++j)
    if (self.pivot(j) < self.pivot(lowest)) lowest = j;
  if (self.pivot(lowest) >= 0.0) return {};
  // With P A P^T = L D L^T and L^T P d = e_j, d^T A d = D_jj.
  const Eigen::VectorXd unit = Eigen::VectorXd::Unit(self.size(), lowest);
  cholmod_dense view = view_of(unit.data(), unit.size(), 1);
  cholmod_dense* permuted = cholmod_solve(CHOLMOD_Lt, self.factor, &view, &self.common);
  cholmod_dense* direction = cholmod_solve(CHOLMOD_Pt, self.factor, permuted, &self.common);
  const Eigen::VectorXd result =
      Eigen::Map<const Eigen::VectorXd>(static_cast<double*>(direction->x), self.size());
  cholmod_free_dense(&permuted, &self.common);
  cholmod_free_dense(&direction, &self.common);
  return result;
}

int SymmetricFactor::analyses() const { return implementation_->analyses; }
int SymmetricFactor::factorisations() const { return implementation_->factorisations; }

}  // namespace tencer::linalg
