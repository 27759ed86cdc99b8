#include "compliance.hpp"

#include <tencer/equilibrium/modal.hpp>

namespace tencer::ground_structure {

std::optional<linalg::SymmetricFactor> compliance(const equilibrium::System& system,
                                                  const model::State& state) {
  constexpr double min_mass = 2000;  // in the unit of eigenvalues
  constexpr double max_mass = 1e15;
  linalg::SymmetricMatrix matrix = system.pattern();
  system.hessian(state, system.internal_forces(state), matrix);
  const Eigen::VectorXd mass =
      equilibrium::eigenvalue_unit(system.structure()) * equilibrium::lumped_mass(system);
  linalg::SymmetricFactor factor;
  for (double scale = min_mass; scale < max_mass; scale *= 4) {
    linalg::SymmetricMatrix heavier = matrix;
    for (int i = 0; i < heavier.cols(); ++i) heavier.coeffRef(i, i) += scale * mass[i];
    if (factor.factorise(heavier) && factor.inertia().negative == system.saddle_unknowns())
      return factor;
  }
  return std::nullopt;
}

}  // namespace tencer::ground_structure
