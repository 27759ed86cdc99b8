#include "dense_ldlt.hpp"

#include <limits>
#include <tencer/linalg/dense.hpp>

#include "significant_pivot.hpp"

namespace tencer::linalg {
namespace {

// L D L^T with 1x1 pivots is backward stable up to the growth of its terms over the entries of the
// matrix. On random indefinite matrices of 60 to 600 unknowns the growth is 1e2..1e6, which leaves
// nine digits or more; beyond this limit the eigen-decomposition takes over.
constexpr double growth_limit = 1e7;

enum class Quality { good, singular, inaccurate };

Quality quality_of(const Eigen::LDLT<Eigen::MatrixXd>& factor, const Eigen::VectorXd& row_maxima) {
  // Eigen reports a zero pivot in front of a nonzero column.
  if (factor.info() != Eigen::Success) return Quality::inaccurate;
  const Eigen::MatrixXd l = factor.matrixL();
  const Eigen::VectorXd magnitudes = factor.vectorD().cwiseAbs();
  const Eigen::VectorXd terms = l.cwiseAbs2() * magnitudes;
  const Eigen::VectorXd maxima = factor.transpositionsP() * row_maxima;
  if (((terms.array() > growth_limit * maxima.array()) && (maxima.array() > 0.0)).any())
    return Quality::inaccurate;
  for (Eigen::Index j = 0; j < magnitudes.size(); ++j)
    if (!is_significant_pivot(magnitudes[j], terms[j] - magnitudes[j])) return Quality::singular;
  return Quality::good;
}

}  // namespace

bool DenseLdlt::factorise(const SymmetricMatrix& matrix, double shift) {
  Eigen::MatrixXd dense = Eigen::MatrixXd(matrix);
  dense.diagonal().array() += shift;
  if (!dense.allFinite()) return false;
  const Eigen::MatrixXd full = dense.selfadjointView<Eigen::Lower>();
  factor_.emplace<Pivoted>(full);
  switch (quality_of(std::get<Pivoted>(factor_), full.cwiseAbs().rowwise().maxCoeff())) {
    case Quality::good:
      return true;
    case Quality::singular:
      return false;
    case Quality::inaccurate:
      break;
  }
  const auto& spectral = factor_.emplace<Eigenpairs>(symmetric_eigenpairs(full));
  if (!spectral.converged) return false;
  const Eigen::VectorXd magnitudes = spectral.values.cwiseAbs();
  return magnitudes.minCoeff() > static_cast<double>(full.rows()) *
                                     std::numeric_limits<double>::epsilon() * magnitudes.maxCoeff();
}

Eigen::VectorXd DenseLdlt::signed_values() const {
  if (const auto* pivoted = std::get_if<Pivoted>(&factor_)) return pivoted->vectorD();
  return std::get<Eigenpairs>(factor_).values;
}

Inertia DenseLdlt::inertia() const {
  const Eigen::VectorXd values = signed_values();
  Inertia inertia;
  inertia.negative = static_cast<int>((values.array() < 0.0).count());
  inertia.positive = static_cast<int>(values.size()) - inertia.negative;
  return inertia;
}

Eigen::MatrixXd DenseLdlt::solve(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides) const {
  if (const auto* pivoted = std::get_if<Pivoted>(&factor_)) return pivoted->solve(right_hand_sides);
  const auto& [values, v, converged] = std::get<Eigenpairs>(factor_);
  return v * (values.cwiseInverse().asDiagonal() * (v.transpose() * right_hand_sides));
}

Eigen::VectorXd DenseLdlt::negative_curvature() const {
  Eigen::Index lowest = 0;
  if (signed_values().minCoeff(&lowest) >= 0.0) return {};
  if (const auto* spectral = std::get_if<Eigenpairs>(&factor_))
    return spectral->vectors.col(lowest);
  // With P A P^T = L D L^T and L^T P d = e_j, d^T A d = D_jj.
  const auto& pivoted = std::get<Pivoted>(factor_);
  Eigen::VectorXd direction = Eigen::VectorXd::Unit(pivoted.rows(), lowest);
  pivoted.matrixU().solveInPlace(direction);
  return pivoted.transpositionsP().transpose() * direction;
}

}  // namespace tencer::linalg
