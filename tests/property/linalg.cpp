#include <tencer/linalg/nonnegative.hpp>
#include <tencer/linalg/symmetric_factor.hpp>

#include "eigenvalues.hpp"
#include "generators.hpp"

using namespace tencer;
using namespace tencer::property;

TEST_CASE("the inertia of a factorisation is that of the eigenvalues") {
  rc::prop("sparse and full, definite and not, scaled unevenly", [] {
    const int n = whole(1, 40);
    const double fill = number(0, 1);
    const Eigen::VectorXd diagonal = numbers(n, -2, 3), scale = numbers(n, -3, 3);
    linalg::SymmetricMatrix matrix(n, n);
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < n; ++j) {
      entries.emplace_back(j, j, diagonal[j] * std::pow(10, 2 * scale[j]));
      for (int i = j + 1; i < n; ++i)
        if (number(0, 1) < fill)
          entries.emplace_back(i, j, number(-1, 1) * std::pow(10, scale[i] + scale[j]));
    }
    matrix.setFromTriplets(entries.begin(), entries.end());
    const double shift = whole(0, 1) * number(0, 10);
    Eigen::MatrixXd full = Eigen::MatrixXd(matrix).selfadjointView<Eigen::Lower>();
    full.diagonal().array() += shift;
    // Signs are the same once the uneven scale is taken off, and eigenvalues then tell them.
    const Eigen::VectorXd even = full.cwiseAbs().rowwise().maxCoeff().cwiseSqrt().cwiseMax(1e-9);
    const Eigen::VectorXd values = tencer::test::eigenvalues(
        even.cwiseInverse().asDiagonal() * full * even.cwiseInverse().asDiagonal());
    RC_PRE(values.cwiseAbs().minCoeff() > 1e-6);
    linalg::SymmetricFactor factor;
    RC_ASSERT(factor.factorise(matrix, shift));
    const linalg::Inertia found = factor.inertia();
    RC_ASSERT(found.negative == (values.array() < 0).count());
    RC_ASSERT(found.positive == (values.array() > 0).count());
    RC_ASSERT(found.zero == 0);
    const Eigen::VectorXd b = numbers(n, -1, 1).cwiseProduct(even);
    const Eigen::VectorXd x = factor.solve(b);
    RC_ASSERT(largest(even.cwiseInverse().asDiagonal() * (full * x - b)) <
              1e-8 * (1 + largest(even.asDiagonal() * x)));
  });
}

TEST_CASE("a nonnegative program meets its optimality conditions") {
  rc::prop("least squares with columns that depend on each other, and prices on them", [] {
    const int rows = whole(1, 12), columns = whole(1, 30);
    Eigen::MatrixXd b = numbers(rows * columns, -1, 1).reshaped(rows, columns);
    for (int j = 1; j < columns; ++j) {
      const int like = whole(0, 3 * columns);  // now and then a multiple of an earlier one
      if (like < j) b.col(j) = number(0.5, 2) * b.col(like);
    }
    const Eigen::VectorXd c = numbers(rows, -1, 1);
    const Eigen::VectorXd price =
        coin() ? numbers(columns, 0, 0.1) : Eigen::VectorXd::Zero(columns);
    const Eigen::MatrixXd a = b.transpose() * b;
    const Eigen::VectorXd right = b.transpose() * c - price;
    const auto found = linalg::solve_nonnegative(a, right);
    RC_ASSERT(found.converged());
    Eigen::VectorXd z = Eigen::VectorXd::Zero(columns);
    for (std::size_t i = 0; i < found.set.size(); ++i)
      z[found.set[i]] = found.values[static_cast<Eigen::Index>(i)];
    RC_ASSERT(z.minCoeff() >= 0);
    const Eigen::VectorXd slope = right - a * z;
    const double rounding = 1e-9 + 1e-12 * largest(a) * largest(z);
    RC_ASSERT(slope.maxCoeff() <= rounding);
    for (const int j : found.set) RC_ASSERT(std::abs(slope[j]) <= rounding);
  });
}
