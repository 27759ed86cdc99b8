// Decompositions of small dense matrices, as functions: a source that names Eigen's classes
// compiles them anew, each for 5 to 30 seconds.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <tencer/linalg/eigenpairs.hpp>

namespace tencer::linalg {

// Of a symmetric matrix, of which only the lower half is read. Without values where the iteration
// does not converge.
Eigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& matrix);

// Of A v = value B v, A and B symmetric and B positive definite; V^T B V = I.
Eigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

// An orthonormal basis of the columns by QR with pivoting. Directions of sizes up to `negligible`
// are dropped.
struct Span {
  Eigen::MatrixXd basis{};  // rows x rank
  // Of the sizes the smallest, also of what was dropped; there are none of no columns.
  double least = std::numeric_limits<double>::infinity();
};
Span span_of(const Eigen::MatrixXd& columns, double negligible);

// An orthonormal basis of {x : matrix x = 0}: of the right singular vectors those of values up to
// `tolerance` times the largest. The matrix has a row or more.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& matrix, double tolerance);

// X with A X nearest to B, and of these the one of least size. `tolerance`: sizes up to so many
// times the largest count as 0.
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double tolerance);

}  // namespace tencer::linalg
