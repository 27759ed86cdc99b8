#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <latch>
#include <limits>
#include <tencer/linalg/symmetric_factor.hpp>
#include <thread>
#include <utility>
#include <vector>

#include "eigenvalues.hpp"
#include "random_symmetric.hpp"

using namespace tencer::linalg;
using namespace tencer::linalg::test;

namespace {

int negative_eigenvalues(const Eigen::MatrixXd& matrix) {
  return static_cast<int>((tencer::test::eigenvalues(matrix).array() < 0.0).count());
}

// Relative to |A| |x|, which is what a backward stable solve keeps small.
double residual(const Eigen::MatrixXd& a, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
  return (a * x - b).norm() / (a.norm() * x.norm());
}

SymmetricMatrix lower_of(const Eigen::MatrixXd& matrix) {
  return Eigen::MatrixXd(matrix.triangularView<Eigen::Lower>()).sparseView();
}

}  // namespace

TEST_CASE("inertia, solves and negative curvature agree with dense algebra at every fill") {
  std::mt19937 random(11);
  for (const double fill : {0.0, 0.02, 0.1, 0.3, 1.0})
    for (const int n : {1, 2, 13, 60, 140})
      for (int repeat = 0; repeat < 6; ++repeat) {
        const SymmetricMatrix matrix = random_symmetric(n, fill, random);
        const double shift = repeat % 2 == 0 ? 0.0 : 0.4 * std::sqrt(n);
        const Eigen::MatrixXd dense = full(matrix) + shift * Eigen::MatrixXd::Identity(n, n);
        CAPTURE(fill, n, repeat);
        SymmetricFactor factor;
        REQUIRE(factor.factorise(matrix, shift));

        const Inertia inertia = factor.inertia();
        CHECK(inertia.negative == negative_eigenvalues(dense));
        CHECK(inertia.negative + inertia.positive == n);
        CHECK(inertia.zero == 0);

        const Eigen::MatrixXd b = Eigen::MatrixXd::Random(n, 3);
        const Eigen::MatrixXd x = factor.solve(b);
        CHECK(factor.solve(Eigen::MatrixXd(n, 0)).cols() == 0);
        Eigen::VectorXd single;
        factor.solve(b.col(0), single);
        for (int k = 0; k < 3; ++k) CHECK(residual(dense, x.col(k), b.col(k)) < 1e-9);
        CHECK(residual(dense, single, b.col(0)) < 1e-9);

        const Eigen::VectorXd d = factor.negative_curvature();
        if (inertia.negative == 0) {
          CHECK(d.size() == 0);
        } else {
          REQUIRE(d.size() == n);
          CHECK(d.dot(dense * d) < 0.0);
        }
      }
}

TEST_CASE("a positive definite full matrix is solved to rounding") {
  const int n = 150;
  const Eigen::MatrixXd root = Eigen::MatrixXd::Random(n, n);
  const Eigen::MatrixXd matrix = root * root.transpose() + Eigen::MatrixXd::Identity(n, n);
  SymmetricFactor factor;
  REQUIRE(factor.factorise(lower_of(matrix)));
  CHECK(factor.inertia().positive == n);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(n);
  Eigen::VectorXd x;
  factor.solve(b, x);
  CHECK(residual(matrix, x, b) < 1e-14);
}

// The cases 1x1 pivots cannot do, or only with a loss of digits.
TEST_CASE("full indefinite matrices with a vanishing diagonal are factorised accurately") {
  std::mt19937 random(5);
  for (const double diagonal : {0.0, 1e-14, 1e-9}) {
    SymmetricMatrix matrix = random_symmetric(80, 1.0, random);
    for (int i = 0; i < 80; ++i) matrix.coeffRef(i, i) *= diagonal;
    const Eigen::MatrixXd dense = full(matrix);
    CAPTURE(diagonal);
    SymmetricFactor factor;
    REQUIRE(factor.factorise(matrix));
    CHECK(factor.inertia().negative == negative_eigenvalues(dense));
    const Eigen::VectorXd b = Eigen::VectorXd::Ones(80);
    const Eigen::VectorXd x = factor.solve(b);
    CHECK(residual(dense, x, b) < 1e-13);
    const Eigen::VectorXd d = factor.negative_curvature();
    REQUIRE(d.size() == 80);
    CHECK(d.dot(dense * d) < 0.0);
  }
}

TEST_CASE("the analysis is kept while the pattern stays the same") {
  std::mt19937 random(2);
  for (const double fill : {0.05, 1.0}) {
    SymmetricMatrix matrix = random_symmetric(40, fill, random);
    SymmetricFactor factor;
    for (int repeat = 1; repeat <= 5; ++repeat) {
      matrix.coeffs() *= 1.1;
      REQUIRE(factor.factorise(matrix, 0.1 * repeat));
      CHECK(factor.analyses() == 1);
      CHECK(factor.factorisations() == repeat);
    }
    const SymmetricMatrix other = random_symmetric(41, fill, random);
    REQUIRE(factor.factorise(other));
    CHECK(factor.analyses() == 2);
    const Eigen::VectorXd b = Eigen::VectorXd::Ones(41);
    CHECK(residual(full(other), factor.solve(b), b) < 1e-10);
  }
}

TEST_CASE("a full pattern may follow a sparse one in the same factor") {
  std::mt19937 random(9);
  SymmetricFactor factor;
  for (const double fill : {0.02, 1.0, 0.02}) {
    const SymmetricMatrix matrix = random_symmetric(70, fill, random);
    REQUIRE(factor.factorise(matrix));
    const Eigen::VectorXd b = Eigen::VectorXd::Ones(70);
    CHECK(residual(full(matrix), factor.solve(b), b) < 1e-10);
  }
}

TEST_CASE("singular and non-finite matrices are refused, and a shift makes them usable") {
  SymmetricFactor factor;
  SECTION("free path") {
    const SymmetricMatrix matrix = free_path_laplacian(50);
    CHECK_FALSE(factor.factorise(matrix));
    CHECK(factor.inertia().zero > 0);
    CHECK_THROWS_AS(factor.solve(Eigen::VectorXd::Ones(50).eval()), std::invalid_argument);
    CHECK(factor.factorise(matrix, 0.01));
    CHECK(factor.inertia().positive == 50);
  }
  SECTION("rank deficient and full") {
    const Eigen::MatrixXd root = Eigen::MatrixXd::Random(30, 29);
    const SymmetricMatrix matrix = lower_of(root * root.transpose());
    CHECK_FALSE(factor.factorise(matrix));
    CHECK(factor.inertia().zero > 0);
    CHECK(factor.factorise(matrix, 0.1));
  }
  SECTION("zero") {
    const SymmetricMatrix matrix = lower_of(Eigen::MatrixXd::Zero(4, 4));
    CHECK_FALSE(factor.factorise(matrix));
    CHECK(factor.inertia().zero > 0);
  }
  SECTION("not a number") {
    for (const double fill : {0.05, 1.0}) {
      std::mt19937 random(1);
      SymmetricMatrix matrix = random_symmetric(40, fill, random);
      matrix.coeffRef(17, 17) = std::numeric_limits<double>::quiet_NaN();
      CHECK_FALSE(factor.factorise(matrix));
      CHECK(factor.inertia().zero > 0);
    }
  }
}

TEST_CASE("badly scaled unknowns do not make a matrix singular") {
  const int n = 40;
  Eigen::VectorXd scale(n);
  for (int i = 0; i < n; ++i) scale[i] = std::pow(10.0, 16.0 * i / (n - 1) - 8.0);
  const Eigen::MatrixXd path =
      scale.asDiagonal() * full(fixed_path_laplacian(n)) * scale.asDiagonal();
  SymmetricFactor factor;
  CHECK(factor.factorise(lower_of(path)));
  CHECK(factor.inertia().positive == n);
}

TEST_CASE("the cost of a factorisation is that of its pattern") {
  // A path eliminated from its ends fills nothing up: a diagonal and n - 1 entries beside it.
  const int n = 500;
  SymmetricFactor path;
  REQUIRE(path.factorise(fixed_path_laplacian(n)));
  CHECK(path.cost().bytes == (2 * n - 1) * (sizeof(double) + sizeof(int)));
  CHECK(path.cost().operations < 5 * n);
  std::mt19937 random(8);
  SymmetricFactor full;
  REQUIRE(full.factorise(random_symmetric(60, 1.0, random)));
  CHECK(full.cost().bytes == 60 * 60 * sizeof(double));
}

TEST_CASE("several threads solve with one factor as one thread does") {
  constexpr int threads = 4, rounds = 5000, columns = 40;
  std::mt19937 random(3);
  for (const double fill : {0.02, 1.0}) {
    const SymmetricMatrix matrix = random_symmetric(90, fill, random);
    SymmetricFactor factor;
    REQUIRE(factor.factorise(matrix));
    const Eigen::MatrixXd b = Eigen::MatrixXd::Random(90, columns);
    Eigen::MatrixXd single(90, columns);
    for (int k = 0; k < columns; ++k) {
      Eigen::VectorXd x;
      factor.solve(b.col(k), x);
      single.col(k) = x;
    }
    const Eigen::MatrixXd several = factor.solve(b);
    const Eigen::VectorXd direction = factor.negative_curvature();
    REQUIRE(direction.size() == 90);

    std::array<int, threads> wrong{};
    std::latch ready(threads);
    std::vector<std::thread> workers;
    for (int t = 0; t < threads; ++t)
      workers.emplace_back([&, t] {
        Eigen::VectorXd x;
        ready.arrive_and_wait();
        for (int round = 0; round < rounds; ++round) {
          const int k = (7 * t + round) % columns;
          factor.solve(b.col(k), x);
          wrong[t] += x != single.col(k);
          if (round % 100 == t) wrong[t] += factor.solve(b) != several;
          if (round % 100 == t + 5) wrong[t] += factor.negative_curvature() != direction;
        }
      });
    for (auto& worker : workers) worker.join();
    CAPTURE(fill);
    for (const int count : wrong) CHECK(count == 0);
  }
}

TEST_CASE("a moved factor keeps its factorisation") {
  SymmetricFactor factor;
  REQUIRE(factor.factorise(fixed_path_laplacian(12)));
  const SymmetricFactor moved = std::move(factor);
  CHECK(moved.inertia().positive == 12);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(12);
  CHECK(residual(full(fixed_path_laplacian(12)), moved.solve(b), b) < 1e-14);
}

TEST_CASE("what the caller gets wrong is refused") {
  SymmetricFactor factor;
  CHECK_THROWS_AS(factor.factorise(SymmetricMatrix(3, 4)), std::invalid_argument);
  REQUIRE(factor.factorise(fixed_path_laplacian(5)));
  CHECK_THROWS_AS(factor.solve(Eigen::VectorXd::Ones(4).eval()), std::invalid_argument);
}
