// Bounded problems whose answers are known, for the tests of the optimizers.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <tencer/optimize/problem.hpp>

namespace tencer::optimize::test {

struct Known {
  Problem problem;
  Eigen::VectorXd start;
  Eigen::VectorXd answer;
};

// 1/2 (p-c)^T A (p-c) on [0,1]^12, A with a condition number of 100. c is chosen so that, by the
// first-order conditions, the answer has four parameters at 0, three at 1 and the others between.
Known quadratic_with_active_bounds();

// Rosenbrock's valley with x <= 0.8, which cuts its bottom at (0.8, 0.64).
Known rosenbrock_cut_off();

// sum of (p-c)^4 + (p-c)^2, without bounds, from far away.
Known convex_quartic();

// |p - c|^4 + |p - c|^2 on [-5,5]^2, where nothing can be evaluated at or beyond x + y = 1. Such a
// place gives `missing`. With centre (0.4, 0.4) the answer lies just inside; with (1, 1) beyond.
Known with_an_edge(const Eigen::Vector2d& c, std::optional<double> missing);

}  // namespace tencer::optimize::test
