#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/constrained.hpp>
#include <tencer/linalg/dense.hpp>
#include <tencer/linalg/lowest_eigenpairs.hpp>

namespace tencer::equilibrium {
namespace {

// An orthonormal basis of the rigid motions in mass-weighted coordinates.
Eigen::MatrixXd weighted_basis(const std::vector<RigidModes>& modes,
                               const Eigen::VectorXd& root_mass) {
  Eigen::Index count = 0;
  for (const auto& mode : modes) count += mode.basis.cols();
  Eigen::MatrixXd rigid(root_mass.size(), count);
  if (count == 0) return rigid;
  count = 0;
  for (const auto& mode : modes) {
    rigid.middleCols(count, mode.basis.cols()) = mode.basis;
    count += mode.basis.cols();
  }
  const Eigen::MatrixXd weighted = root_mass.asDiagonal() * rigid;
  return linalg::span_of(weighted, 1e-9 * weighted.colwise().norm().maxCoeff()).basis;
}

void remove_rigid_parts(const std::vector<RigidModes>& modes, Eigen::MatrixXd& motions) {
  for (Eigen::Index k = 0; k < motions.cols(); ++k) remove_rigid(modes, motions.col(k));
}

}  // namespace

std::vector<int> taut_cables(const Eigen::VectorXd& tensions) {
  constexpr double slack_tension = 1e-9;
  const double largest = tensions.size() > 0 ? tensions.maxCoeff() : 0;
  std::vector<int> taut;
  for (int c = 0; c < tensions.size(); ++c)
    if (tensions[c] > slack_tension * largest) taut.push_back(c);
  return taut;
}

System taut_system(const model::Structure& structure, const model::State& state,
                   const Eigen::VectorXd& tensions, const std::vector<int>& taut) {
  constexpr double rho = 0.99;
  core::require(tensions.size() == static_cast<Eigen::Index>(structure.cables.size()),
                "taut_system: needs one tension per cable");
  model::Structure springs = structure;
  springs.cables.clear();
  const System lengths(structure);
  for (const int c : taut) {
    const double length = model::span_of(lengths.stencils()[c], state).norm();
    springs::Cable cable = structure.cables[c];
    cable.rest_length = rho * length;
    cable.stiffness = tensions[c] / (length * (1 - rho));
    cable.tension_only = false;
    springs.cables.push_back(cable);
  }
  return System(std::move(springs));
}

Eigen::MatrixXd length_gradients(const System& system, const model::State& state) {
  Eigen::MatrixXd gradients =
      Eigen::MatrixXd::Zero(system.size(), static_cast<Eigen::Index>(system.stencils().size()));
  for (std::size_t c = 0; c < system.stencils().size(); ++c) {
    const auto& stencil = system.stencils()[c];
    const Eigen::Vector3d t = model::span_of(stencil, state).normalized();
    system.for_each_unknown(stencil, [&](int at, int axis, double weight) {
      gradients(at, static_cast<Eigen::Index>(c)) += weight * t[axis];
    });
  }
  return gradients;
}

ConstrainedHessian::ConstrainedHessian(const System& system, const model::State& state,
                                       Eigen::MatrixXd constraints, const Eigen::VectorXd& mass)
    : system_(system), constraints_(std::move(constraints)), root_mass_(mass.cwiseSqrt()) {
  const auto& cables = system.structure().cables;
  core::require(
      constraints_.cols() == 0 || constraints_.cols() == static_cast<Eigen::Index>(cables.size()),
      "ConstrainedHessian: needs the length gradients of all cables or of none");
  spring_stiffness_.resize(constraints_.cols());
  for (Eigen::Index c = 0; c < constraints_.cols(); ++c) spring_stiffness_[c] = cables[c].stiffness;
  at_.rigid = rigid_modes(system, state);
  at_.matrix = system.pattern();
  system.hessian(state, system.internal_forces(state), at_.matrix);
  rigid_ = weighted_basis(at_.rigid, root_mass_);
  Eigen::Index motions = 0;
  for (const auto& mode : at_.rigid) motions += mode.basis.cols();
  spins_ = rigid_.cols() < motions;
}

// Anchored only when there is no shift: a shift makes rigid motion regular by itself.
bool ConstrainedHessian::factorise(double shift) {
  shift_ = shift;
  linalg::SymmetricMatrix shifted = at_.matrix;
  if (shift == 0) {
    stabilise(system_, at_.rigid, shifted);
  } else {
    for (int i = 0; i < shifted.cols(); ++i)
      shifted.coeffRef(i, i) += shift * root_mass_[i] * root_mass_[i];
    // Nothing that has mass feels where the angle is held, so this is exact.
    if (spins_)
      for (const auto& unknowns : system_.stabilising_unknowns())
        for (const int i : unknowns)
          if (root_mass_[i] == 0) shifted.coeffRef(i, i) *= 2;
  }
  diagonal_ = shifted.diagonal();
  if (!at_.factor.factorise(shifted)) return false;
  negative_ = at_.factor.inertia().negative - system_.saddle_unknowns();
  if (constraints_.cols() == 0) return true;
  // In([A G; G^T 0]) = In(A) + In(-S), S = G^T A^-1 G, and as many negative ones as G has rank
  // belong to the constraints. Dependent cables make S singular: its null space does not count.
  compliance_columns_ = at_.factor.solve(constraints_);
  const linalg::Eigenpairs compliance =
      linalg::symmetric_eigenpairs(constraints_.transpose() * compliance_columns_);
  if (!compliance.converged) return false;
  const Eigen::VectorXd& values = compliance.values;
  const double zero = 1e-12 * values.cwiseAbs().maxCoeff();
  const Eigen::VectorXd inverses = (values.array().abs() > zero).select(values.cwiseInverse(), 0.0);
  rank_ = static_cast<int>((values.array().abs() > zero).count());
  negative_ -= static_cast<int>((values.array() < -zero).count());
  stiffness_ = compliance.vectors * inverses.asDiagonal() * compliance.vectors.transpose();
  return true;
}

ConstrainedResponse ConstrainedHessian::respond(const Eigen::MatrixXd& force,
                                                const Eigen::MatrixXd& length) const {
  // What is factorised is H + A D A^T, D the stiffness of the springs, so that dt comes out less
  // D length.
  ConstrainedResponse result{.motion = at_.factor.solve(force)};
  if (constraints_.cols() > 0) {
    result.tension = stiffness_ * (constraints_.transpose() * result.motion - length);
    result.motion -= compliance_columns_ * result.tension;
    result.tension += spring_stiffness_.asDiagonal() * length;
  }
  remove_rigid_parts(at_.rigid, result.motion);
  return result;
}

Eigen::VectorXd ConstrainedHessian::motion(const Eigen::VectorXd& force) const {
  return respond(force, Eigen::MatrixXd::Zero(constraints_.cols(), 1)).motion;
}

ConstrainedModes ConstrainedHessian::lowest(int count) const {
  const int n = system_.size();
  const auto massive = static_cast<int>((root_mass_.array() > 0).count());
  const int most = massive - static_cast<int>(rigid_.cols()) - rank_;
  count = std::min({count, most, n - 1});
  if (n < 3 || count < 1) return {};
  Eigen::VectorXd force(n), motion(n);
  const auto inverse = [&](const double* in, double* out) {
    Eigen::VectorXd z = Eigen::Map<const Eigen::VectorXd>(in, n);
    if (rigid_.size() > 0) z -= rigid_ * (rigid_.transpose() * z);
    force = root_mass_.cwiseProduct(z);
    at_.factor.solve(force, motion);
    if (constraints_.cols() > 0)
      motion -= compliance_columns_ * (stiffness_ * (constraints_.transpose() * motion));
    z = root_mass_.cwiseProduct(motion);
    if (rigid_.size() > 0) z -= rigid_ * (rigid_.transpose() * z);
    Eigen::Map<Eigen::VectorXd>(out, n) = z;
  };
  auto pairs = linalg::lowest_eigenpairs(inverse, n, count);
  if (!pairs.converged || !pairs.values.allFinite()) return {};
  ConstrainedModes result{.values = pairs.values.array() - shift_,
                          .motions = std::move(pairs.vectors),
                          .converged = true};
  for (auto&& mode : result.motions.colwise()) {
    mode = (root_mass_.array() > 0).select(mode.cwiseQuotient(root_mass_), 0.0);
    mode /= mode.cwiseAbs().maxCoeff();
  }
  return result;
}

}  // namespace tencer::equilibrium
