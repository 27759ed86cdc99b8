// Dense factorisation for matrices that fill up anyway: L D L^T with diagonal pivoting, and an
// eigen-decomposition for the few indefinite matrices on which that is not accurate. LAPACK's
// dsytrf (Bunch-Kaufman) would need no second method, but with the BLAS that Debian installs it
// takes 1.2 to 3 times as long as this on matrices of 100 to 1500 unknowns (43 ms against 22 at
// 600), and its last bits change with whichever BLAS a machine has.
#pragma once

#include <Eigen/Cholesky>
#include <tencer/linalg/eigenpairs.hpp>
#include <tencer/linalg/symmetric_factor.hpp>
#include <variant>

namespace tencer::linalg {

class DenseLdlt {
 public:
  // Multiplications and additions a factorisation of that many unknowns takes.
  static double operations(Eigen::Index size) {
    const auto n = static_cast<double>(size);
    return n * n * n / 3.0;
  }

  // matrix + shift * identity. False when a pivot or an eigenvalue is lost in rounding.
  [[nodiscard]] bool factorise(const SymmetricMatrix& matrix, double shift);
  Inertia inertia() const;
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides) const;
  Eigen::VectorXd negative_curvature() const;

 private:
  using Pivoted = Eigen::LDLT<Eigen::MatrixXd>;

  Eigen::VectorXd signed_values() const;  // D or the eigenvalues

  std::variant<Pivoted, Eigenpairs> factor_;
};

}  // namespace tencer::linalg
