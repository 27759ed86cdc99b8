// Quadratic programs over nonnegative variables, least squares among them, by the active-set method
// of Lawson and Hanson.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

namespace tencer::linalg {

// Minimise z^T A z / 2 - b^T z over z >= 0, A symmetric positive semidefinite, of which only the
// columns of variables that become positive are ever asked for. For least squares |B z - c|^2,
// A = B^T B and b = B^T c.
struct NonnegativeProblem {
  int size = 0;
  // b - A z into `slope` (size), z given by its positive entries: `values` at `set`.
  std::function<void(std::span<const int> set, const Eigen::VectorXd& values,
                     Eigen::VectorXd& slope)>
      slope{};
  // A(set, j) with A(j, j) as the last entry, set.size() + 1 in all.
  std::function<Eigen::VectorXd(std::span<const int> set, int j)> column{};
  // Asked after each step; true ends the search. May be empty.
  std::function<bool(std::span<const int> set, const Eigen::VectorXd& values)> enough{};
};

struct NonnegativeOptions {
  // No variable enters whose slope is smaller than this; in the units of b.
  double tolerance = 1e-10;
  int max_steps = 10000;
};

// The positive variables; all others are zero. At the solution slope is zero at `set` and at most
// the tolerance elsewhere. Variables whose column depends on those in the set do not enter.
struct Nonnegative {
  std::vector<int> set{};
  Eigen::VectorXd values{};
  int steps = 0;
  bool converged = false;  // or `enough` said so
};

Nonnegative solve_nonnegative(const NonnegativeProblem& problem,
                              const NonnegativeOptions& options = {});

// The same with A and b given.
Nonnegative solve_nonnegative(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                              const NonnegativeOptions& options = {});

}  // namespace tencer::linalg
