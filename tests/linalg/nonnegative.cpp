#include <Eigen/Dense>
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <random>
#include <stdexcept>
#include <tencer/linalg/nonnegative.hpp>

using namespace tencer::linalg;

namespace {

Eigen::VectorXd full(const Nonnegative& found, Eigen::Index size) {
  Eigen::VectorXd z = Eigen::VectorXd::Zero(size);
  for (std::size_t i = 0; i < found.set.size(); ++i)
    z[found.set[i]] = found.values[static_cast<Eigen::Index>(i)];
  return z;
}

double value(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, const Eigen::VectorXd& z) {
  return 0.5 * z.dot(A * z) - b.dot(z);
}

// The first-order conditions, which are sufficient, to `digits` of the largest number in b or A z.
void check_optimal(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, const Nonnegative& found,
                   double digits = 1e-10) {
  CHECK(found.converged());
  REQUIRE(found.values.size() == static_cast<Eigen::Index>(found.set.size()));
  CHECK((found.values.size() == 0 || found.values.minCoeff() > 0));
  auto sorted = found.set;
  std::ranges::sort(sorted);
  CHECK(std::ranges::adjacent_find(sorted) == sorted.end());
  const Eigen::VectorXd z = full(found, b.size());
  const Eigen::VectorXd slope = b - A * z;
  const double scale =
      std::max(b.lpNorm<Eigen::Infinity>(), (A * z).lpNorm<Eigen::Infinity>()) * digits;
  CHECK(slope.maxCoeff() <= scale);
  for (const int j : found.set) CHECK(std::abs(slope[j]) <= scale);
}

struct Random {
  std::mt19937 engine;
  std::normal_distribution<double> normal{};

  Eigen::MatrixXd matrix(Eigen::Index rows, Eigen::Index columns) {
    Eigen::MatrixXd m(rows, columns);
    for (double& entry : m.reshaped()) entry = normal(engine);
    return m;
  }
  Eigen::MatrixXd whole_numbers(Eigen::Index rows, Eigen::Index columns) {
    std::uniform_int_distribution<int> digit(-2, 2);
    Eigen::MatrixXd m(rows, columns);
    for (double& entry : m.reshaped()) entry = digit(engine);
    return m;
  }
};

// The lowest value over all sets of variables that may be positive.
double brute_force(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  const auto n = static_cast<int>(b.size());
  double lowest = 0;
  for (unsigned subset = 1; subset < (1U << n); ++subset) {
    std::vector<int> set;
    for (int j = 0; j < n; ++j)
      if (subset >> j & 1U) set.push_back(j);
    const Eigen::MatrixXd part = A(set, set);
    const Eigen::VectorXd slope = b(set);
    const Eigen::LDLT<Eigen::MatrixXd> factor(part);
    if (factor.vectorD().minCoeff() < 1e-9 * part.diagonal().maxCoeff()) continue;
    const Eigen::VectorXd z = factor.solve(slope);
    if (z.minCoeff() >= 0) lowest = std::min(lowest, -0.5 * slope.dot(z));
  }
  return lowest;
}

}  // namespace

TEST_CASE("nonnegative least squares meets the first-order conditions") {
  Random random{.engine = std::mt19937(1)};
  for (int trial = 0; trial < 60; ++trial) {
    const int n = 1 + trial * 2;
    const int rank = 1 + trial % 5 * n / 4;  // from 1 to more than n
    const Eigen::MatrixXd B = random.matrix(rank, n);
    const Eigen::VectorXd c = random.matrix(rank, 1);
    CAPTURE(n, rank);
    const Nonnegative found = solve_nonnegative(B.transpose() * B, B.transpose() * c);
    check_optimal(B.transpose() * B, B.transpose() * c, found);
    CHECK(static_cast<int>(found.set.size()) <= std::min(n, rank));
  }
}

TEST_CASE("a solution that is known is found, with most of its variables at zero") {
  Random random{.engine = std::mt19937(2)};
  const int n = 300, m = 120;
  const Eigen::MatrixXd B = random.matrix(m, n);
  Eigen::VectorXd z = Eigen::VectorXd::Zero(n);
  for (int j = 0; j < n; j += 12) z[j] = 1 + j % 5;
  // Columns in general position, few of them in the answer and those strictly: it is the only one.
  Eigen::VectorXd slope = -random.matrix(n, 1).cwiseAbs() - Eigen::VectorXd::Constant(n, 0.1);
  for (int j = 0; j < n; j += 12) slope[j] = 0;
  const Eigen::MatrixXd A = B.transpose() * B;
  const Nonnegative found = solve_nonnegative(A, A * z + slope);
  check_optimal(A, A * z + slope, found);
  CHECK((full(found, n) - z).lpNorm<Eigen::Infinity>() < 1e-10);
}

TEST_CASE("the value agrees with the lowest over all sets of positive variables") {
  Random random{.engine = std::mt19937(3)};
  const bool whole = GENERATE(false, true);  // whole numbers: ties, copies, columns of zeros
  for (int trial = 0; trial < 400; ++trial) {
    const int n = 1 + trial % 8;
    const int rank = 1 + trial / 8 % 8;
    const Eigen::MatrixXd B = whole ? random.whole_numbers(rank, n) : random.matrix(rank, n);
    Eigen::VectorXd b =
        B.transpose() * (whole ? random.whole_numbers(rank, 1) : random.matrix(rank, 1));
    // A price on each variable, which takes b out of A's range and keeps the value bounded.
    if (trial % 2 == 1) b -= random.matrix(n, 1).cwiseAbs();
    const Eigen::MatrixXd A = B.transpose() * B;
    CAPTURE(n, rank, trial);
    const Nonnegative found = solve_nonnegative(A, b);
    check_optimal(A, b, found);
    CHECK(value(A, b, full(found, n)) == Approx(brute_force(A, b)).epsilon(1e-9).margin(1e-11));
  }
}

TEST_CASE("of equal columns the cheaper is taken, whichever is the steeper") {
  // Column 1 is half of column 0 and costs less for what it does.
  const Eigen::Matrix2d A{{4, 2}, {2, 1}};
  const Eigen::Vector2d b(2.2, 1.2);
  const Nonnegative found = solve_nonnegative(A, b);
  REQUIRE(found.set == std::vector<int>{1});
  CHECK(found.values[0] == Approx(1.2));
  CHECK(found.converged());
}

TEST_CASE("copies of columns with prices: every exchange is found") {
  Random random{.engine = std::mt19937(4)};
  const int rank = 12, n = 240;
  const Eigen::MatrixXd basis = random.matrix(rank, 2 * rank);
  Eigen::MatrixXd B(rank, n);
  Eigen::VectorXd price(n);
  for (int j = 0; j < n; ++j) {
    const double scale = 0.5 + j % 7;
    B.col(j) = scale * basis.col(j % basis.cols());
    price[j] = 1e-3 * scale * (1 + 0.5 * std::sin(j));
  }
  const Eigen::MatrixXd A = B.transpose() * B;
  const Eigen::VectorXd b = B.transpose() * random.matrix(rank, 1) - price;
  const Nonnegative found = solve_nonnegative(A, b);
  check_optimal(A, b, found);
  CHECK(static_cast<int>(found.set.size()) <= rank);
}

TEST_CASE("nearly equal columns and columns of very different lengths") {
  Random random{.engine = std::mt19937(5)};
  for (const double apart : {1e-3, 1e-6, 1e-8, 1e-12, 0.0}) {
    CAPTURE(apart);
    const int m = 20, n = 60;
    Eigen::MatrixXd B = random.matrix(m, n);
    B.rightCols(n / 2) = B.leftCols(n / 2) + apart * random.matrix(m, n / 2);
    for (int j = 0; j < n; ++j) B.col(j) *= std::pow(10, j % 9 - 4);
    const Eigen::VectorXd c = random.matrix(m, 1);
    const Nonnegative found =
        solve_nonnegative(B.transpose() * B, B.transpose() * c, {.tolerance = 1e-9});
    CHECK(found.converged());
    const Eigen::VectorXd rest = c - B * full(found, n);
    // In the units of each column.
    for (int j = 0; j < n; ++j) CHECK(B.col(j).dot(rest) <= 1e-6 * B.col(j).norm());
    CHECK(found.steps < 20 * n);
  }
}

TEST_CASE("b that lets no variable in, or ties all of them") {
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(5, 5);
  for (const double level : {-1.0, 0.0}) {
    const Nonnegative none = solve_nonnegative(identity, Eigen::VectorXd::Constant(5, level));
    CHECK(none.converged());
    CHECK(none.set.empty());
    CHECK(none.steps == 0);
  }
  const Nonnegative all = solve_nonnegative(identity, Eigen::VectorXd::Ones(5));
  CHECK(full(all, 5) == Eigen::VectorXd::Ones(5));
  // All equal, and equal to each other's mixture: any split of 1 is a solution.
  const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(5, 5);
  const Nonnegative tied = solve_nonnegative(ones, Eigen::VectorXd::Ones(5));
  check_optimal(ones, Eigen::VectorXd::Ones(5), tied);
  CHECK(tied.set.size() == 1);
  // The slope of every variable vanishes at once when the first has entered.
  const Eigen::Matrix3d A{{2, 1, 1}, {1, 2, 1}, {1, 1, 2}};
  const Nonnegative degenerate = solve_nonnegative(A, Eigen::Vector3d(2, 1, 1));
  check_optimal(A, Eigen::Vector3d(2, 1, 1), degenerate);
  CHECK(degenerate.set == std::vector<int>{0});
}

TEST_CASE("no variables") {
  const Nonnegative found = solve_nonnegative(Eigen::MatrixXd(0, 0), Eigen::VectorXd(0));
  CHECK(found.converged());
  CHECK(found.set.empty());
  CHECK(found.values.size() == 0);
}

TEST_CASE("a value without a lowest is told") {
  const Nonnegative flat = solve_nonnegative(Eigen::MatrixXd::Zero(2, 2), Eigen::Vector2d(-1, 1));
  CHECK(flat.reason == NonnegativeReason::unbounded);
  // Falls along (1, 1).
  const Eigen::Matrix2d A{{1, -1}, {-1, 1}};
  const Nonnegative found = solve_nonnegative(A, Eigen::Vector2d(1, 1));
  CHECK(found.reason == NonnegativeReason::unbounded);
  CHECK(found.values.allFinite());
  CHECK(solve_nonnegative(A, Eigen::Vector2d(1, -1)).converged());
}

TEST_CASE("only the columns of variables that may enter are asked for") {
  Random random{.engine = std::mt19937(6)};
  const int n = 400, m = 30;
  const Eigen::MatrixXd B = random.matrix(m, n);
  const Eigen::VectorXd c = random.matrix(m, 1);
  int columns = 0, asked = 0;
  NonnegativeProblem problem{.size = n};
  problem.slope = [&](std::span<const int> set, const Eigen::VectorXd& values,
                      Eigen::VectorXd& slope) {
    Eigen::VectorXd rest = c;
    for (std::size_t i = 0; i < set.size(); ++i)
      rest -= values[static_cast<Eigen::Index>(i)] * B.col(set[i]);
    slope = B.transpose() * rest;
  };
  problem.column = [&](std::span<const int> set, int j) {
    ++columns;
    Eigen::VectorXd column(static_cast<Eigen::Index>(set.size()) + 1);
    for (std::size_t i = 0; i < set.size(); ++i)
      column[static_cast<Eigen::Index>(i)] = B.col(set[i]).dot(B.col(j));
    column[column.size() - 1] = B.col(j).squaredNorm();
    return column;
  };
  const Nonnegative found = solve_nonnegative(problem);
  check_optimal(B.transpose() * B, B.transpose() * c, found);
  CHECK(columns == found.steps);
  CHECK(found.steps < n / 2);

  SECTION("enough ends the search after the step it is told of") {
    double before = 0.5 * c.squaredNorm();
    problem.enough = [&](std::span<const int> set, const Eigen::VectorXd& values) {
      Eigen::VectorXd rest = c;
      for (std::size_t i = 0; i < set.size(); ++i)
        rest -= values[static_cast<Eigen::Index>(i)] * B.col(set[i]);
      CHECK(0.5 * rest.squaredNorm() < before);  // each step is a descent
      CHECK(values.minCoeff() > 0);
      before = 0.5 * rest.squaredNorm();
      return ++asked == 4;
    };
    const Nonnegative early = solve_nonnegative(problem);
    CHECK(early.reason == NonnegativeReason::enough);
    CHECK(early.converged());
    CHECK(asked == 4);
    CHECK(early.steps == 4);
    CHECK(early.set.size() <= 4);
  }
  SECTION("the limit of steps ends it without convergence") {
    const Nonnegative early = solve_nonnegative(problem, {.max_steps = 3});
    CHECK(early.reason == NonnegativeReason::step_limit);
    CHECK_FALSE(early.converged());
    CHECK(early.steps == 3);
    CHECK_FALSE(early.set.empty());
  }
}

TEST_CASE("numbers that are not finite end the search and are told") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Eigen::Matrix2d A = Eigen::Matrix2d::Identity();
  const Eigen::Vector2d b(1, 1);
  for (const Nonnegative& found :
       {solve_nonnegative(A, Eigen::Vector2d(1, nan)), solve_nonnegative(infinity * A, b)}) {
    CHECK(found.reason == NonnegativeReason::not_finite);
    CHECK_FALSE(found.converged());
    CHECK(found.set.empty());
  }

  // The first step is good, and what it found stays.
  int slopes = 0, columns = 0;
  bool slope_fails = false;
  NonnegativeProblem problem{.size = 2};
  problem.slope = [&](std::span<const int> set, const Eigen::VectorXd& values,
                      Eigen::VectorXd& slope) {
    slope = Eigen::Vector2d(2, 1);
    for (std::size_t i = 0; i < set.size(); ++i)
      slope[set[i]] -= values[static_cast<Eigen::Index>(i)];
    if (slope_fails && slopes++ == 1) slope[1] = nan;
  };
  problem.column = [&](std::span<const int> set, int) {
    Eigen::VectorXd column = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(set.size()) + 1);
    column[column.size() - 1] = !slope_fails && columns++ == 1 ? infinity : 1;
    return column;
  };
  for (const bool in_slope : {false, true}) {
    slope_fails = in_slope;
    const Nonnegative found = solve_nonnegative(problem);
    CAPTURE(in_slope);
    CHECK(found.reason == NonnegativeReason::not_finite);
    REQUIRE(found.set == std::vector<int>{0});
    CHECK(found.values[0] == 2);
  }
}

TEST_CASE("a caller's mistakes with nonnegative programs") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Matrix2d A = Eigen::Matrix2d::Identity();
  const Eigen::Vector2d b(1, 1);
  CHECK_THROWS_AS(solve_nonnegative(A, Eigen::Vector3d(1, 1, 1)), std::invalid_argument);
  CHECK_THROWS_AS(solve_nonnegative(Eigen::MatrixXd(2, 3), b), std::invalid_argument);
  CHECK_THROWS_AS(solve_nonnegative(-A, b), std::invalid_argument);
  CHECK_THROWS_AS(solve_nonnegative(A, b, {.tolerance = nan}), std::invalid_argument);
  CHECK_THROWS_AS(solve_nonnegative(A, b, {.max_steps = 0}), std::invalid_argument);
  NonnegativeProblem problem{.size = 2};
  CHECK_THROWS_AS(solve_nonnegative(problem), std::invalid_argument);
  problem.slope = [&](auto, const auto&, Eigen::VectorXd& slope) { slope.setOnes(3); };
  problem.column = [](auto, int) { return Eigen::VectorXd(Eigen::VectorXd::Ones(1)); };
  CHECK_THROWS_AS(solve_nonnegative(problem), std::invalid_argument);
  problem.slope = [&](auto, const auto&, Eigen::VectorXd& slope) { slope.setOnes(); };
  problem.column = [](auto, int) { return Eigen::VectorXd(Eigen::VectorXd::Ones(7)); };
  CHECK_THROWS_AS(solve_nonnegative(problem), std::invalid_argument);
}
