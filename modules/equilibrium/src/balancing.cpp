#include <cmath>
#include <tencer/equilibrium/balancing.hpp>
#include <tencer/equilibrium/constrained.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/linalg/nonnegative.hpp>

#include "forces.hpp"
#include "pulling_cables.hpp"

namespace tencer::equilibrium {
namespace {

// Factorises the rods' Hessian plus the smallest multiple tried of their softest stiffness that
// makes it positive definite.
bool linearise_rods(const System& system, const model::State& state, Linearisation& at) {
  constexpr double smallest = 1;
  constexpr double largest = 1e9;
  linearise(system, state, at);
  const Eigen::VectorXd softest = softest_stiffness(system);
  double added = 0;
  for (double shift = smallest; !(at.regular && at.negative == 0) && shift <= largest;
       shift *= 10) {
    for (Eigen::Index j = 0; j < softest.size(); ++j)
      at.matrix.valuePtr()[at.matrix.outerIndexPtr()[j]] += (shift - added) * softest[j];
    added = shift;
    at.regular = at.factor.factorise(at.matrix);
    at.negative = at.regular ? at.factor.inertia().negative - system.saddle_unknowns() : 0;
  }
  return at.regular && at.negative == 0;
}

}  // namespace

Eigen::VectorXd balancing_tensions(const model::Structure& structure, const model::State& state) {
  constexpr double sharing = 1e-6;  // of a cable's compliance: what lets equal cables share
  const auto count = static_cast<Eigen::Index>(structure.cables.size());
  Eigen::VectorXd tensions = Eigen::VectorXd::Zero(count);
  if (count == 0) return tensions;
  model::Structure without = structure;
  Eigen::VectorXd limits(count);
  for (Eigen::Index c = 0; c < count; ++c) {
    auto& cable = without.cables[static_cast<std::size_t>(c)];
    limits[c] = cable.rest_length;
    cable.rest_length = 0;
    cable.stiffness = 0;
  }
  const System system(without);
  Linearisation at;
  const Eigen::VectorXd gradient = system.rod_gradient(state);
  if (!gradient.allFinite() || !linearise_rods(system, state, at)) return tensions;
  const Eigen::MatrixXd pulls = length_gradients(system, state);
  Eigen::MatrixXd compliance = pulls.transpose() * at.solve(pulls);
  compliance.diagonal() *= 1 + sharing;
  const Eigen::VectorXd excess =
      cable_lengths(system, state) - limits - pulls.transpose() * at.solve(gradient).col(0);
  if (!compliance.allFinite() || !excess.allFinite()) return tensions;
  const linalg::Nonnegative found = linalg::solve_nonnegative(
      compliance, excess, {.tolerance = 1e-9 * excess.cwiseAbs().maxCoeff()});
  for (std::size_t k = 0; k < found.set.size(); ++k)
    tensions[found.set[k]] = found.values[static_cast<Eigen::Index>(k)];
  return tensions;
}

}  // namespace tencer::equilibrium
