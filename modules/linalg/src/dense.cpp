#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <tencer/linalg/dense.hpp>

namespace tencer::linalg {
namespace {

template <class Solver>
Eigenpairs pairs_of(const Solver& solver) {
  if (solver.info() != Eigen::Success) return {};
  return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors(), .converged = true};
}

}  // namespace

Eigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& matrix) {
  return pairs_of(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix));
}

Eigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return pairs_of(Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(a, b));
}

Span span_of(const Eigen::MatrixXd& columns, double negligible) {
  if (columns.cols() == 0 || columns.rows() == 0)
    return {.basis = Eigen::MatrixXd(columns.rows(), 0)};
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  const Eigen::VectorXd sizes = qr.matrixQR().diagonal().cwiseAbs();
  const auto rank = std::ranges::find_if(sizes, [&](double size) { return !(size > negligible); }) -
                    sizes.begin();
  return {.basis = qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), rank),
          .least = sizes.minCoeff()};
}

Eigen::MatrixXd null_space(const Eigen::MatrixXd& matrix, double tolerance) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullV);
  const auto& values = svd.singularValues();
  const auto rank = (values.array() > tolerance * values[0]).count();
  return svd.matrixV().rightCols(matrix.cols() - rank);
}

Eigen::MatrixXd least_squares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
                              double tolerance) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factor(a.rows(), a.cols());
  factor.setThreshold(tolerance);
  return factor.compute(a).solve(b);
}

}  // namespace tencer::linalg
