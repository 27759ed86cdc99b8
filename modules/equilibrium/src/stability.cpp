#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/constrained.hpp>
#include <tencer/equilibrium/modal.hpp>
#include <tencer/equilibrium/stability.hpp>

#include "balanced_stability.hpp"
#include "forces.hpp"

namespace tencer::equilibrium {
namespace {

// Leaves `hessian` factorised without a shift where no eigenvalue is negative.
Stability lowest_eigenvalue(const System& system, const Eigen::VectorXd& mass,
                            ConstrainedHessian& hessian) {
  Stability result;
  const int floating = floating_components(hessian.rigid());
  result.floating_components = floating > 1 ? floating : 0;
  if (!hessian.factorise()) return result;
  result.negative = hessian.negative();
  const double unit = eigenvalue_unit(system.structure());
  for (double shift = unit; hessian.negative() > 0; shift *= 10)
    if (!hessian.factorise(shift) || !std::isfinite(shift)) return result;
  const ConstrainedModes modes = hessian.lowest(1);
  if (!modes.converged) return result;
  result.computed = true;
  result.mode = modes.motions.col(0);
  result.smallest_eigenvalue = modes.values[0] / unit;
  result.rounding = curvature_rounding(hessian.diagonal(), result.mode) /
                    result.mode.cwiseAbs2().dot(mass) / unit;
  return result;
}

}  // namespace

Stability stability(const System& system, const model::State& state) {
  const Eigen::VectorXd mass = lumped_mass(system);
  ConstrainedHessian hessian(system, state, Eigen::MatrixXd(system.size(), 0), mass);
  return lowest_eigenvalue(system, mass, hessian);
}

BalancedStability balanced_stability(const model::Structure& structure, const model::State& state,
                                     const Eigen::VectorXd& tensions, const std::vector<int>& taut,
                                     const Eigen::VectorXd& gradient) {
  core::require(tensions.size() == static_cast<Eigen::Index>(structure.cables.size()),
                "stability_inextensible: needs one tension per cable");
  const System system = taut_system(structure, state, tensions, taut);
  const Eigen::VectorXd mass = lumped_mass(system);
  ConstrainedHessian hessian(system, state, length_gradients(system, state), mass);
  BalancedStability result{.stability = lowest_eigenvalue(system, mass, hessian)};
  if (result.stability.stable())
    result.turn = largest_rotation(system, state, hessian.motion(gradient));
  return result;
}

Stability stability_inextensible(const model::Structure& structure, const model::State& state,
                                 const Eigen::VectorXd& tensions, const std::vector<int>& taut) {
  return balanced_stability(structure, state, tensions, taut,
                            Eigen::VectorXd::Zero(System(structure).size()))
      .stability;
}

}  // namespace tencer::equilibrium
