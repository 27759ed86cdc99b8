// Design parameters of the cables and how the forces on a structure depend on them.
#pragma once

#include <Eigen/Core>
#include <Eigen/Sparse>
#include <span>
#include <tencer/equilibrium/system.hpp>
#include <tencer/springs/parameter.hpp>
#include <vector>

namespace tencer::sensitivity {

// The values of the parameters in `cables`, and `cables` with these values (P entries). Throw
// std::invalid_argument for a cable that does not exist or a position of an anchored end.
Eigen::VectorXd values(std::span<const springs::Cable> cables,
                       std::span<const springs::Parameter> parameters);
std::vector<springs::Cable> with_values(std::vector<springs::Cable> cables,
                                        std::span<const springs::Parameter> parameters,
                                        const Eigen::VectorXd& p);

// Below, g = dE/dx is the gradient in the free unknowns, p the parameters. Where an attachment is
// exactly at a vertex, derivatives in s are one-sided: those of the edge that the system puts it on
// (System's `side`; Side::after gives the derivative for growing s).

// dg/dp, size x P, at most 12 entries a column.
using ParameterJacobian = Eigen::SparseMatrix<double>;
ParameterJacobian force_derivatives(const equilibrium::System& system, const model::State& state,
                                    std::span<const springs::Parameter> parameters);

// (dg/dp)^T y without forming dg/dp; y: size entries, result: P.
Eigen::VectorXd force_derivatives_transposed(const equilibrium::System& system,
                                             const model::State& state,
                                             std::span<const springs::Parameter> parameters,
                                             const Eigen::VectorXd& y);

// Second derivatives of y^T g, y (size) held: `mixed` in x and p, size x P, and `parameters` in p,
// P x P.
struct ForceCurvature {
  ParameterJacobian mixed{};
  ParameterJacobian parameters{};
};
ForceCurvature force_curvature(const equilibrium::System& system, const model::State& state,
                               std::span<const springs::Parameter> parameters,
                               const Eigen::VectorXd& y);

// Those in x alone, the derivative of the Hessian of E along y, times each column of v (size x k).
Eigen::MatrixXd third_derivative_times(const equilibrium::System& system, const model::State& state,
                                       const Eigen::VectorXd& y,
                                       const Eigen::Ref<const Eigen::MatrixXd>& v);

}  // namespace tencer::sensitivity
