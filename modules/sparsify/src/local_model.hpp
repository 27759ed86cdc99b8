// What a network in equilibrium answers to small changes of its cables, to first order.
#pragma once

#include <Eigen/Core>
#include <tencer/sensitivity/derivatives.hpp>
#include <tencer/symmetry/group.hpp>
#include <vector>

namespace tencer::sparsify {

// Where the variables of a model come from: an arc length that is free to slide, or a rest length.
struct FreePosition {
  int variable = 0;
  springs::OnRod at{};
};

// p: the rest lengths of the cables and the arc lengths of their ends, cable by cable; z: the
// variables, p = p0 + ties z, which are those of the first cable of each orbit (all of p without
// symmetry). Rest lengths rather than force densities are varied since stiff cables answer to them
// gently everywhere; force densities q = tension / length follow.
struct LocalModel {
  std::vector<sensitivity::Parameter> parameters{};  // P
  Eigen::SparseMatrix<double> ties{};                // P x Z
  std::vector<int> rest_lengths{};                   // per orbit, its variable
  std::vector<FreePosition> positions{};             // the other variables
  std::vector<std::vector<int>> orbits{};            // the cables of each, O
  Eigen::MatrixXd motion{};                          // dx/dz, size x Z
  sensitivity::LeastSquares distance{};              // from the target, in z
  Eigen::VectorXd density{}, length{};               // of each orbit's first cable
  Eigen::MatrixXd density_rates{}, length_rates{};   // O x Z
};

// group: may be null. kept: the first cables, which stay as they are and are in no orbit; only
// without a group.
LocalModel local_model(const sensitivity::Configuration& at, const sensitivity::Target& target,
                       const symmetry::Group* group, int kept = 0);

}  // namespace tencer::sparsify
