// Derivatives of the design objective T(x*(p)) in the parameters of the cables, x* the equilibrium
// (paper section 5.3): implicit differentiation of g(x*, p) = 0 with the factorised Hessian.
//
// All hold at a converged, stable configuration, and where rigid motions of the structure that its
// supports allow leave T alone: a free structure needs Target::align, and groups of rods that no
// cable ties together have no defined distance from the target. Quantities in free unknowns have no
// rigid part.
#pragma once

#include <Eigen/Core>
#include <Eigen/Sparse>
#include <span>
#include <tencer/sensitivity/distance.hpp>
#include <tencer/sensitivity/parameters.hpp>
#include <tencer/sensitivity/tracker.hpp>

namespace tencer::sensitivity {

// The adjoint state y = -H^+ dT/dx, one solve.
Eigen::VectorXd adjoint(const Configuration& at, const Distance& distance);

// dT/dp = y^T dg/dp, P entries.
Eigen::VectorXd gradient(const Configuration& at, std::span<const springs::Parameter> parameters,
                         const Eigen::VectorXd& adjoint);

// dx*/dp = -H^+ dg/dp, size x P, P solves.
Eigen::MatrixXd state_derivatives(const Configuration& at,
                                  std::span<const springs::Parameter> parameters);
// dx*/dz for parameters p = p0 + ties z (ties: P x Z), size x Z, Z solves.
Eigen::MatrixXd state_derivatives(const Configuration& at,
                                  std::span<const springs::Parameter> parameters,
                                  const Eigen::SparseMatrix<double>& ties);

// T near the configuration as |residual + jacobian dp|^2, rigid motion projected out (see
// Distance): gradient 2 J^T r, Gauss-Newton matrix 2 J^T J.
struct LeastSquares {
  Eigen::VectorXd residual{};  // 3 per vertex of every rod
  Eigen::MatrixXd jacobian{};  // 3 per vertex x P

  Eigen::VectorXd gradient() const { return 2 * (jacobian.transpose() * residual); }
  Eigen::MatrixXd gauss_newton() const;
};
LeastSquares least_squares(const Distance& distance, const Eigen::MatrixXd& state_derivatives);

// d2T/dp2 times q (P), exact, two solves.
Eigen::VectorXd hessian_times(const Configuration& at,
                              std::span<const springs::Parameter> parameters,
                              const Distance& distance, const Eigen::VectorXd& adjoint,
                              const Eigen::VectorXd& q);

// d2T/dp2, P x P, exact and symmetric, no solve beyond those in state_derivatives.
Eigen::MatrixXd hessian(const Configuration& at, std::span<const springs::Parameter> parameters,
                        const Distance& distance, const Eigen::VectorXd& adjoint,
                        const Eigen::MatrixXd& state_derivatives);

}  // namespace tencer::sensitivity
