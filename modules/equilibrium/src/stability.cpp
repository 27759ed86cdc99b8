#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/modal.hpp>
#include <tencer/equilibrium/stability.hpp>
#include <tencer/linalg/lowest_eigenpairs.hpp>
#include <tencer/springs/law.hpp>

#include "balanced_stability.hpp"
#include "forces.hpp"

namespace tencer::equilibrium {
namespace {

// Lanczos on the inverse of H + shift M, restricted to the null space of the constraints' columns
// (size x m) and of rigid motion; shift makes H positive definite there.
class Spectrum {
 public:
  Spectrum(const System& system, const model::State& state, Eigen::MatrixXd constraints)
      : system_(system),
        constraints_(std::move(constraints)),
        root_mass_(lumped_mass(system).cwiseSqrt()) {
    at_.rigid = rigid_modes(system, state);
    at_.matrix = system.pattern();
    system.hessian(state, system.internal_forces(state), at_.matrix);
    Eigen::Index modes = 0;
    for (const auto& rigid : at_.rigid) modes += rigid.basis.cols();
    Eigen::MatrixXd rigid(system.size(), modes);
    modes = 0;
    for (const auto& mode : at_.rigid) {
      rigid.middleCols(modes, mode.basis.cols()) = mode.basis;
      modes += mode.basis.cols();
    }
    const Eigen::MatrixXd weighted = root_mass_.asDiagonal() * rigid;
    if (modes == 0) return;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(weighted);
    qr.setThreshold(1e-9);
    rigid_ = qr.householderQ() * Eigen::MatrixXd::Identity(system.size(), qr.rank());
    spins_ = qr.rank() < modes;
  }

  // How far the Newton step that balances `gradient` turns an edge; after run() found no negative
  // eigenvalue.
  double turn(const model::State& state, const Eigen::VectorXd& gradient) const {
    Eigen::VectorXd step = at_.factor.solve(gradient);
    if (constraints_.cols() > 0)
      step -= compliance_columns_ * (stiffness_ * (constraints_.transpose() * step));
    remove_rigid(at_.rigid, step);
    return largest_rotation(system_, state, step);
  }

  Stability run() {
    Stability result;
    const int floating = floating_components(at_.rigid);
    result.floating_components = floating > 1 ? floating : 0;
    double shift = 0;
    if (!factorise(0)) return result;
    result.negative = negative_;
    const double unit = eigenvalue_unit(system_.structure());
    for (shift = unit; negative_ > 0; shift *= 10)
      if (!factorise(shift) || !std::isfinite(shift)) return result;
    result.computed = lowest(result);
    return result;
  }

 private:
  // Anchored only when there is no shift: a shift makes rigid motion regular by itself.
  bool factorise(double shift) {
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
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> compliance(constraints_.transpose() *
                                                                    compliance_columns_);
    const Eigen::VectorXd& values = compliance.eigenvalues();
    const double zero = 1e-12 * values.cwiseAbs().maxCoeff();
    const Eigen::VectorXd inverses =
        (values.array().abs() > zero).select(values.cwiseInverse(), 0.0);
    negative_ -= static_cast<int>((values.array() < -zero).count());
    stiffness_ =
        compliance.eigenvectors() * inverses.asDiagonal() * compliance.eigenvectors().transpose();
    return true;
  }

  bool lowest(Stability& result) {
    const int n = system_.size();
    if (n < 3) return false;
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
    const auto pairs = linalg::lowest_eigenpairs(inverse, n, 1);
    if (!pairs.converged || !std::isfinite(pairs.values[0])) return false;
    result.mode = pairs.vectors.col(0);
    for (int i = 0; i < n; ++i)
      result.mode[i] = root_mass_[i] > 0 ? result.mode[i] / root_mass_[i] : 0;
    result.mode /= result.mode.cwiseAbs().maxCoeff();
    const double unit = eigenvalue_unit(system_.structure());
    result.smallest_eigenvalue = (pairs.values[0] - shift_) / unit;
    const double mass = root_mass_.cwiseProduct(result.mode).squaredNorm();
    result.rounding = curvature_rounding(diagonal_, result.mode) / mass / unit;
    return true;
  }

  const System& system_;
  Eigen::MatrixXd constraints_;
  Eigen::VectorXd root_mass_;
  Eigen::MatrixXd rigid_;  // orthonormal, in mass-weighted coordinates
  bool spins_ = false;     // a straight rod with frames may turn about itself, moving no mass
  Linearisation at_;
  Eigen::VectorXd diagonal_;  // of what is factorised
  Eigen::MatrixXd compliance_columns_;
  Eigen::MatrixXd stiffness_;  // pseudo-inverse of the cables' compliance
  double shift_ = 0;
  int negative_ = 0;
};

}  // namespace

Stability stability(const System& system, const model::State& state) {
  return Spectrum(system, state, Eigen::MatrixXd(system.size(), 0)).run();
}

BalancedStability balanced_stability(const model::Structure& structure, const model::State& state,
                                     const Eigen::VectorXd& tensions, const std::vector<int>& taut,
                                     const Eigen::VectorXd& gradient) {
  core::require(tensions.size() == static_cast<Eigen::Index>(structure.cables.size()),
                "stability_inextensible: needs one tension per cable");
  // The taut cables as stiff springs of the same tension: on motions that keep their lengths this
  // changes nothing, and off them it makes the matrix regular.
  constexpr double rho = 0.99;
  model::Structure springs = structure;
  springs.cables.clear();
  const System lengths(structure);
  for (int c : taut) {
    const double length = model::span_of(lengths.stencils()[c], state).norm();
    springs::Cable cable = structure.cables[c];
    cable.rest_length = rho * length;
    cable.stiffness = tensions[c] / (length * (1 - rho));
    cable.tension_only = false;
    springs.cables.push_back(cable);
  }
  const System system(springs);
  Eigen::MatrixXd constraints =
      Eigen::MatrixXd::Zero(system.size(), static_cast<Eigen::Index>(taut.size()));
  for (std::size_t c = 0; c < taut.size(); ++c) {
    const auto& stencil = system.stencils()[c];
    const Eigen::Vector3d t = model::span_of(stencil, state).normalized();
    system.for_each_unknown(stencil, [&](int at, int axis, double weight) {
      constraints(at, static_cast<Eigen::Index>(c)) += weight * t[axis];
    });
  }
  Spectrum spectrum(system, state, std::move(constraints));
  BalancedStability result{.stability = spectrum.run()};
  if (result.stability.stable()) result.turn = spectrum.turn(state, gradient);
  return result;
}

Stability stability_inextensible(const model::Structure& structure, const model::State& state,
                                 const Eigen::VectorXd& tensions, const std::vector<int>& taut) {
  return balanced_stability(structure, state, tensions, taut,
                            Eigen::VectorXd::Zero(System(structure).size()))
      .stability;
}

}  // namespace tencer::equilibrium
