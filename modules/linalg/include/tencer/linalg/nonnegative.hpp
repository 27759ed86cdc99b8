// Quadratic programs over nonnegative variables, least squares among them, by the active-set method
// of Lawson and Hanson (Solving Least Squares Problems, 1974).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

namespace tencer::linalg {

// Minimise z^T A z / 2 - b^T z over z >= 0, A symmetric positive semidefinite, of which only the
// columns of variables that become positive are ever asked for. For least squares |B z - c|^2,
// A = B^T B and b = B^T c. The functions are called in the thread of the search; what they throw
// passes through it.
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

  // Throws std::invalid_argument naming the option that is wrong.
  void validate() const;
};

enum class NonnegativeReason {
  solved,      // no variable may enter any more
  enough,      // NonnegativeProblem::enough said so
  step_limit,  // NonnegativeOptions::max_steps
  unbounded,   // as far as rounding tells the value falls for ever along a direction in which A is
               // flat (to 1e-12 of its diagonal)
  not_finite   // A or b, or what the problem's functions made of them, is not finite
};

// The positive variables; all others are zero. At the solution slope is zero at `set` and at most
// the tolerance, or what rounding leaves of it, elsewhere. The columns of the set do not depend on
// each other, and a solution is found whether or not those of A do. However the search ended, set
// and values are where it came to; the values are finite unless a step overflowed.
struct [[nodiscard]] Nonnegative {
  std::vector<int> set{};
  Eigen::VectorXd values{};
  int steps = 0;
  NonnegativeReason reason = NonnegativeReason::not_finite;

  bool converged() const {
    return reason == NonnegativeReason::solved || reason == NonnegativeReason::enough;
  }
};

// Throws std::invalid_argument for sizes that do not fit, an A(j, j) below zero and options out of
// range.
Nonnegative solve_nonnegative(const NonnegativeProblem& problem,
                              const NonnegativeOptions& options = {});

// The same with A and b given.
Nonnegative solve_nonnegative(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                              const NonnegativeOptions& options = {});

}  // namespace tencer::linalg
