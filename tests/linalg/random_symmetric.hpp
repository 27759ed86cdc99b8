// Random symmetric matrices with a known size and fill, for the tests of the factorisation.
#pragma once

#include <Eigen/Dense>
#include <random>
#include <tencer/linalg/symmetric_assembler.hpp>
#include <vector>

namespace tencer::linalg::test {

inline Eigen::MatrixXd full(const SymmetricMatrix& lower) {
  return Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
}

// Entries normally distributed; each pair off the diagonal is there with probability `fill`.
inline SymmetricMatrix random_symmetric(int n, double fill, std::mt19937& random) {
  std::normal_distribution<double> value;
  std::uniform_real_distribution<double> chance;
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < n; ++j) {
    entries.emplace_back(j, j, 2.0 * value(random));
    for (int i = j + 1; i < n; ++i)
      if (chance(random) < fill) entries.emplace_back(i, j, value(random));
  }
  SymmetricMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// The second-difference matrix of a path of n vertices with fixed ends: eigenvalues
// 2 - 2 cos(k pi / (n + 1)), k = 1..n.
inline SymmetricMatrix fixed_path_laplacian(int n) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 2.0);
    if (i > 0) entries.emplace_back(i, i - 1, -1.0);
  }
  SymmetricMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// With free ends: eigenvalues 2 - 2 cos(k pi / n), k = 0..n-1, so it is singular.
inline SymmetricMatrix free_path_laplacian(int n) {
  SymmetricMatrix matrix = fixed_path_laplacian(n);
  matrix.coeffRef(0, 0) = 1.0;
  matrix.coeffRef(n - 1, n - 1) = 1.0;
  return matrix;
}

}  // namespace tencer::linalg::test
