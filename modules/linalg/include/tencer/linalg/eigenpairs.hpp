// What looking for eigenvalues gives.
#pragma once

#include <Eigen/Core>

namespace tencer::linalg {

struct [[nodiscard]] Eigenpairs {
  Eigen::VectorXd values;   // ascending, k
  Eigen::MatrixXd vectors;  // n x k, orthonormal columns
  bool converged = false;
};

}  // namespace tencer::linalg
