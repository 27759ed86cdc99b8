// What a network in equilibrium answers to small changes of its cables, to first order.
#pragma once

#include <Eigen/Core>
#include <Eigen/Sparse>
#include <tencer/sensitivity/derivatives.hpp>
#include <tencer/symmetry/group.hpp>
#include <vector>

namespace tencer::elimination {

// A variable that is an arc length, free to slide, and where it is.
struct FreePosition {
  int variable = 0;
  springs::OnRod at{};
};

// p (P): the rest lengths of the cables and the arc lengths of their ends, cable by cable. z (Z):
// the variables, p = p0 + ties z, which are those of the first cable of each orbit (all of p
// without symmetry). Rest lengths rather than force densities are varied since stiff cables answer
// to them gently everywhere; force densities q = tension / length follow. O orbits.
struct LocalModel {
  std::vector<springs::Parameter> parameters{};     // P
  Eigen::SparseMatrix<double> ties{};               // P x Z
  std::vector<int> rest_lengths{};                  // per orbit, its variable
  std::vector<FreePosition> positions{};            // the other variables
  std::vector<std::vector<int>> orbits{};           // the cables of each, O
  Eigen::MatrixXd motion{};                         // dx/dz, size x Z
  sensitivity::LeastSquares distance{};             // from the target, in z
  Eigen::VectorXd density{}, length{};              // of each orbit's first cable, O
  Eigen::MatrixXd density_rates{}, length_rates{};  // d/dz, O x Z
};

// The rest length and the arc lengths of the ends of each cable but for so many of the first, cable
// by cable.
std::vector<springs::Parameter> cable_parameters(const std::vector<springs::Cable>& cables,
                                                 int fixed_cables);

// group: may be null. fixed_cables: so many of the first cables stay as they are and are in no
// orbit. Throws std::invalid_argument for fixed cables together with a group.
LocalModel local_model(const sensitivity::Configuration& at, const model::Target& target,
                       const symmetry::Group* group, int fixed_cables = 0);

}  // namespace tencer::elimination
