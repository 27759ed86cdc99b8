#include "stiffness_floor.hpp"

#include <tencer/linalg/symmetric_factor.hpp>

#include "soft_modes.hpp"

namespace tencer::sparsify {

bool stiffer_than(const sensitivity::Configuration& at, double limit,
                  linalg::SymmetricFactor& workspace) {
  if (limit <= 0) return at.linearisation.regular && at.linearisation.negative == 0;
  linalg::SymmetricMatrix shifted = at.linearisation.matrix;  // anchored against rigid motion
  const Eigen::VectorXd shift = limit * eigenvalue_unit(at.system) * lumped_mass(at.system);
  for (int i = 0; i < shifted.cols(); ++i) shifted.coeffRef(i, i) -= shift[i];
  return workspace.factorise(shifted) &&
         workspace.inertia().negative == at.system.saddle_unknowns();
}

}  // namespace tencer::sparsify
