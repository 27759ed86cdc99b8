// Decompositions against what defines them.
#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/linalg/dense.hpp>

using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace tencer::linalg;

namespace {

// Of rank 2: the last column is the sum of the others.
MatrixXd dependent_columns() {
  MatrixXd matrix = MatrixXd::Random(7, 3);
  matrix.col(2) = matrix.col(0) + matrix.col(1);
  return matrix;
}

}  // namespace

TEST_CASE("Eigenpairs of a symmetric matrix, and of two") {
  const MatrixXd random = MatrixXd::Random(6, 6);
  const MatrixXd a = random + random.transpose();
  const MatrixXd b = random * random.transpose() + MatrixXd::Identity(6, 6);
  const Eigenpairs one = symmetric_eigenpairs(a);
  REQUIRE(one.converged);
  CHECK((a * one.vectors).isApprox(one.vectors * one.values.asDiagonal(), 1e-12));
  CHECK((one.vectors.transpose() * one.vectors).isIdentity(1e-12));
  const Eigenpairs two = symmetric_eigenpairs(a, b);
  REQUIRE(two.converged);
  CHECK((a * two.vectors).isApprox(b * two.vectors * two.values.asDiagonal(), 1e-12));
  CHECK((two.vectors.transpose() * b * two.vectors).isIdentity(1e-12));
  for (const Eigenpairs& pairs : {one, two})
    for (int i = 1; i < 6; ++i) CHECK(pairs.values[i - 1] <= pairs.values[i]);
  CHECK_FALSE(symmetric_eigenpairs(MatrixXd::Constant(2, 2, std::nan(""))).converged);
}

TEST_CASE("A span has a basis of what is not negligible") {
  const MatrixXd columns = dependent_columns();
  const Span span = span_of(columns, 1e-9);
  CHECK(span.basis.cols() == 2);
  CHECK((span.basis.transpose() * span.basis).isIdentity(1e-12));
  CHECK((span.basis * (span.basis.transpose() * columns)).isApprox(columns, 1e-12));
  CHECK(span.least < 1e-12);
  CHECK(span_of(columns.leftCols(2), 1e-9).least > 1e-3);
  CHECK(span_of(MatrixXd(7, 0), 1e-9).basis.cols() == 0);
}

TEST_CASE("A null space is all that a matrix takes to zero") {
  const MatrixXd matrix = dependent_columns();
  const MatrixXd open = null_space(matrix, 1e-9);
  REQUIRE(open.cols() == 1);
  CHECK((matrix * open).norm() < 1e-12);
  CHECK(null_space(MatrixXd::Random(2, 6), 1e-9).cols() == 4);
}

TEST_CASE("Least squares are stationary, and as small as they can be") {
  const MatrixXd a = dependent_columns();
  const MatrixXd b = MatrixXd::Random(7, 2);
  const MatrixXd x = least_squares(a, b, 1e-9);
  CHECK((a.transpose() * (a * x - b)).norm() < 1e-12);
  CHECK((null_space(a, 1e-9).transpose() * x).norm() < 1e-12);
}
