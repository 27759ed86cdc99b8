#include <catch2/catch.hpp>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <tencer/linalg/lowest_eigenpairs.hpp>
#include <tencer/linalg/symmetric_factor.hpp>

#include "random_symmetric.hpp"

using namespace tencer::linalg;
using namespace tencer::linalg::test;

namespace {

InverseOperator inverse_of(const SymmetricFactor& factor, int n) {
  return [&factor, n](const double* in, double* out) {
    Eigen::VectorXd solution;
    factor.solve(Eigen::Map<const Eigen::VectorXd>(in, n), solution);
    Eigen::Map<Eigen::VectorXd>(out, n) = solution;
  };
}

}  // namespace

TEST_CASE("the lowest eigenpairs of a fixed path are its known sines") {
  for (const int n : {6, 30, 200})
    for (const double shift : {0.0, 0.3}) {
      SymmetricFactor factor;
      REQUIRE(factor.factorise(fixed_path_laplacian(n), shift));
      const int count = 4;
      const Eigenpairs pairs = lowest_eigenpairs(inverse_of(factor, n), n, count);
      CAPTURE(n, shift);
      REQUIRE(pairs.converged);
      REQUIRE(pairs.values.size() == count);
      REQUIRE(pairs.vectors.cols() == count);
      const Eigen::MatrixXd gram = pairs.vectors.transpose() * pairs.vectors;
      CHECK((gram - Eigen::MatrixXd::Identity(count, count)).cwiseAbs().maxCoeff() < 1e-10);
      for (int k = 0; k < count; ++k) {
        const double angle = (k + 1) * std::numbers::pi / (n + 1);
        CHECK(pairs.values[k] == Approx(2.0 - 2.0 * std::cos(angle) + shift).epsilon(1e-8));
        Eigen::VectorXd sine(n);
        for (int i = 0; i < n; ++i) sine[i] = std::sin((i + 1) * angle);
        CHECK(std::abs(sine.normalized().dot(pairs.vectors.col(k))) == Approx(1.0).epsilon(1e-8));
      }
    }
}

TEST_CASE("a mode projected out by the operator does not count") {
  const int n = 60;
  const SymmetricMatrix path = free_path_laplacian(n);
  SymmetricFactor factor;
  // A shift on the constant vector's own direction only: anything that makes it invertible.
  REQUIRE(factor.factorise(path, 1e-9));
  const auto projected = [&](const double* in, double* out) {
    Eigen::VectorXd v = Eigen::Map<const Eigen::VectorXd>(in, n);
    v.array() -= v.mean();
    Eigen::VectorXd solution;
    factor.solve(v, solution);
    Eigen::Map<Eigen::VectorXd>(out, n) = solution.array() - solution.mean();
  };
  const Eigenpairs pairs = lowest_eigenpairs(projected, n, 3);
  REQUIRE(pairs.converged);
  for (int k = 0; k < 3; ++k) {
    const double exact = 2.0 - 2.0 * std::cos((k + 1) * std::numbers::pi / n);
    CHECK(pairs.values[k] == Approx(exact + 1e-9).epsilon(1e-7));
  }
}

TEST_CASE("an operator that fails is told of, and its exceptions pass") {
  const int n = 40;
  int calls = 0;
  for (const double bad :
       {0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    calls = 0;
    const Eigenpairs pairs = lowest_eigenpairs(
        [&](const double* in, double* out) {
          const bool fails = bad == 0.0 || ++calls > 3;
          for (int i = 0; i < n; ++i) out[i] = fails ? bad : in[i] / (i + 1);
        },
        n, 3);
    CAPTURE(bad);
    CHECK_FALSE(pairs.converged);
    CHECK(pairs.values.size() == 0);
  }
  const auto throws = [](const double*, double*) { throw std::runtime_error("lost"); };
  CHECK_THROWS_WITH(lowest_eigenpairs(throws, n, 3), "lost");
}

TEST_CASE("as many eigenpairs as unknowns, or none, are the caller's mistake") {
  SymmetricFactor factor;
  REQUIRE(factor.factorise(fixed_path_laplacian(5)));
  CHECK_THROWS_AS(lowest_eigenpairs(inverse_of(factor, 5), 5, 5), std::invalid_argument);
  CHECK_THROWS_AS(lowest_eigenpairs(inverse_of(factor, 5), 5, 0), std::invalid_argument);
}
