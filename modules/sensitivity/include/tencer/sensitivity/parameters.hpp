// Design parameters of the cables and how the forces on a structure depend on them.
#pragma once

#include <Eigen/Core>
#include <Eigen/Sparse>
#include <span>
#include <tencer/equilibrium/system.hpp>
#include <vector>

namespace tencer::sensitivity {

// position_a, position_b: the arc length s at which end a or b is attached to its rod.
enum class Kind { stiffness, rest_length, position_a, position_b };

struct Parameter {
  Kind kind = Kind::stiffness;
  int cable = 0;
};

// The values of the parameters in `cables`, and `cables` with these values (P entries). Throw
// std::invalid_argument for a cable that does not exist or a position of an anchored end.
Eigen::VectorXd values(std::span<const springs::Cable> cables,
                       std::span<const Parameter> parameters);
std::vector<springs::Cable> with_values(std::vector<springs::Cable> cables,
                                        std::span<const Parameter> parameters,
                                        const Eigen::VectorXd& p);

// Below, g = dE/dx is the gradient in the free unknowns, p the parameters. Where an attachment is
// exactly at a vertex, derivatives in s are one-sided: those of the edge that the system puts it on
// (System's `side`; Side::after gives the derivative for growing s).

// dg/dp, size x P, at most 12 entries a column.
using ParameterJacobian = Eigen::SparseMatrix<double>;
ParameterJacobian force_derivatives(const equilibrium::System& system,
                                    const equilibrium::State& state,
                                    std::span<const Parameter> parameters);

// (dg/dp)^T y without forming dg/dp; y: size entries, result: P.
Eigen::VectorXd force_derivatives_transposed(const equilibrium::System& system,
                                             const equilibrium::State& state,
                                             std::span<const Parameter> parameters,
                                             const Eigen::VectorXd& y);

// The third derivative of the energy E(x, p) along two directions (y, 0) and (v, q): derivatives of
// y^T g in x and in p, differentiated once more along (v, q). y, v: size; q: P.
struct SecondDerivatives {
  Eigen::VectorXd unknowns{};    // size: g_xx[y, v] + g_xp[y, q]
  Eigen::VectorXd parameters{};  // P: y^T g_px[v] + y^T g_pp[q]
};
SecondDerivatives second_derivatives(const equilibrium::System& system,
                                     const equilibrium::State& state,
                                     std::span<const Parameter> parameters,
                                     const Eigen::VectorXd& y, const Eigen::VectorXd& v,
                                     const Eigen::VectorXd& q);

}  // namespace tencer::sensitivity
