#include <tencer/core/error.hpp>
#include <tencer/sensitivity/derivatives.hpp>

#include "rigid_free_solve.hpp"

namespace tencer::sensitivity {

Eigen::VectorXd adjoint(const Configuration& at, const Distance& distance) {
  return rigid_free_solve(at, -distance.gradient());
}

Eigen::VectorXd gradient(const Configuration& at, std::span<const springs::Parameter> parameters,
                         const Eigen::VectorXd& adjoint) {
  return force_derivatives_transposed(at.system, at.state, parameters, adjoint);
}

Eigen::MatrixXd state_derivatives(const Configuration& at,
                                  std::span<const springs::Parameter> parameters) {
  return rigid_free_solve(at, -Eigen::MatrixXd(force_derivatives(at.system, at.state, parameters)));
}

Eigen::MatrixXd state_derivatives(const Configuration& at,
                                  std::span<const springs::Parameter> parameters,
                                  const Eigen::SparseMatrix<double>& ties) {
  core::require(ties.rows() == static_cast<Eigen::Index>(parameters.size()),
                "state_derivatives: needs a row of ties for every parameter");
  const ParameterJacobian rates = force_derivatives(at.system, at.state, parameters) * ties;
  return rigid_free_solve(at, -Eigen::MatrixXd(rates));
}

LeastSquares least_squares(const Distance& distance, const Eigen::MatrixXd& state_derivatives) {
  return {.residual = distance.residual(), .jacobian = distance.residual_rates(state_derivatives)};
}

Eigen::MatrixXd LeastSquares::gauss_newton() const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(jacobian.cols(), jacobian.cols());
  result.selfadjointView<Eigen::Lower>().rankUpdate(jacobian.transpose(), 2.0);
  return result.selfadjointView<Eigen::Lower>();
}

Eigen::VectorXd hessian_times(const Configuration& at,
                              std::span<const springs::Parameter> parameters,
                              const Distance& distance, const Eigen::VectorXd& adjoint,
                              const Eigen::VectorXd& q) {
  core::require(q.size() == static_cast<Eigen::Index>(parameters.size()),
                "hessian_times: needs a rate for every parameter");
  const ParameterJacobian rates = force_derivatives(at.system, at.state, parameters);
  const ForceCurvature curvature = force_curvature(at.system, at.state, parameters, adjoint);
  const Eigen::VectorXd motion = rigid_free_solve(at, -(rates * q));
  const Eigen::VectorXd change = distance.hessian_times(motion) +
                                 third_derivative_times(at.system, at.state, adjoint, motion) +
                                 curvature.mixed * q;
  const Eigen::VectorXd adjoint_rate = rigid_free_solve(at, -change);
  return rates.transpose() * adjoint_rate + curvature.mixed.transpose() * motion +
         curvature.parameters * q;
}

Eigen::MatrixXd hessian(const Configuration& at, std::span<const springs::Parameter> parameters,
                        const Distance& distance, const Eigen::VectorXd& adjoint,
                        const Eigen::MatrixXd& state_derivatives) {
  const Eigen::MatrixXd& motions = state_derivatives;
  const ForceCurvature curvature = force_curvature(at.system, at.state, parameters, adjoint);
  const Eigen::MatrixXd mixed = curvature.mixed.transpose() * motions;
  const Eigen::MatrixXd change = distance.hessian_times(motions) +
                                 third_derivative_times(at.system, at.state, adjoint, motions);
  Eigen::MatrixXd result = motions.transpose() * change;
  result += mixed + mixed.transpose() + Eigen::MatrixXd(curvature.parameters);
  return (result + result.transpose()) / 2;
}

}  // namespace tencer::sensitivity
