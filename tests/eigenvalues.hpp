// The dense symmetric eigenproblem, for tests that compare with it: compiled once, for it takes the
// compiler as long as all the rest of such a test.
#pragma once

#include <Eigen/Core>

namespace tencer::test {

// Of a symmetric matrix, ascending.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);

}  // namespace tencer::test
