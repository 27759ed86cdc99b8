// The linear change of variables that keeps a network of cables symmetric: p = matrix z + offset
// (paper section 5.3, "Symmetry constraints").
#pragma once

#include <Eigen/Core>
#include <Eigen/Sparse>
#include <span>
#include <tencer/springs/cable.hpp>
#include <tencer/springs/parameter.hpp>
#include <tencer/symmetry/group.hpp>
#include <tencer/symmetry/orbit.hpp>
#include <vector>

namespace tencer::symmetry {

// stiffness stands for any strength that symmetric cables share, such as the force density.
// parameters (P, the entries of p): for each cable in turn its strength (stiffness or rest length,
// as tie_cables is told) and the arc lengths s of its ends a and b, those that are on rods. free
// (Z, the entries of z): those that stay free, all of the first cable of an orbit; bounds on them
// are bounds on the others. matrix: P x Z, one entry in a row, or none for an end that symmetry
// holds fast; 1 for strengths, +-1 for positions on rods of equal length. The arc lengths in p are
// those nearest to the cables' own, not wrapped, so cables may slide across the seam. orbit: for
// each cable, which orbit it belongs to.
struct Ties {
  std::vector<springs::Parameter> parameters{};
  std::vector<springs::Parameter> free{};
  Eigen::SparseMatrix<double> matrix{};
  Eigen::VectorXd offset{};
  std::vector<int> orbit{};
};

// Ties each cable to its images among `cables`, and to itself when it is its own image: a cable
// that a mirror turns round has one free position, an end on a mirror plane none if the whole cable
// lies in it or is turned onto itself. Images that are not in the list are not missed.
// Throws std::invalid_argument when `strength` is a position.
Ties tie_cables(std::span<const springs::Cable> cables, const Group& group,
                springs::ParameterKind strength = springs::ParameterKind::stiffness,
                double tolerance = same_place);

// The z whose parameters are nearest to p (P) in least squares: strengths of an orbit are
// averaged, positions likewise as seen from its first cable.
Eigen::VectorXd project(const Ties& ties, const Eigen::VectorXd& p);

}  // namespace tencer::symmetry
