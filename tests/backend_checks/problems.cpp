#include "problems.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>

namespace tencer::optimize::test {

Known quadratic_with_active_bounds() {
  const int n = 12;
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd basis(n, n);
  for (double& entry : basis.reshaped()) entry = normal(random);
  const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(basis).householderQ();
  Eigen::VectorXd eigenvalues(n);
  for (int i = 0; i < n; ++i) eigenvalues[i] = std::pow(10.0, 2.0 * i / (n - 1) - 1.0);
  const Eigen::MatrixXd a = q * eigenvalues.asDiagonal() * q.transpose();

  Eigen::VectorXd answer(n), slope = Eigen::VectorXd::Zero(n);
  answer << 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.2, 0.35, 0.5, 0.65, 0.9;
  slope.head(4) << 0.5, 1.0, 0.2, 2.0;
  slope.segment(4, 3) << -0.3, -1.5, -0.7;
  const Eigen::VectorXd c = answer - a.llt().solve(slope);

  Known known;
  known.problem.lower = Eigen::VectorXd::Zero(n);
  known.problem.upper = Eigen::VectorXd::Ones(n);
  known.problem.value = [a, c](const Eigen::VectorXd& p) {
    return std::optional(0.5 * (p - c).dot(a * (p - c)));
  };
  known.problem.gradient = [a, c](const Eigen::VectorXd& p, Eigen::VectorXd& g) {
    g = a * (p - c);
    return true;
  };
  known.problem.hessian = [a](const Eigen::VectorXd&, Eigen::MatrixXd& h) {
    h = a;
    return true;
  };
  known.start = Eigen::VectorXd::Constant(n, 0.5);
  known.answer = answer;
  return known;
}

Known rosenbrock_cut_off() {
  Known known;
  known.problem.lower = Eigen::Vector2d(-1.5, -1.0);
  known.problem.upper = Eigen::Vector2d(0.8, 2.0);
  known.problem.value = [](const Eigen::VectorXd& p) {
    return std::optional(100.0 * std::pow(p[1] - p[0] * p[0], 2) + std::pow(1.0 - p[0], 2));
  };
  known.problem.gradient = [](const Eigen::VectorXd& p, Eigen::VectorXd& g) {
    const double off = p[1] - p[0] * p[0];
    g = Eigen::Vector2d(-400.0 * p[0] * off - 2.0 * (1.0 - p[0]), 200.0 * off);
    return true;
  };
  known.problem.hessian = [](const Eigen::VectorXd& p, Eigen::MatrixXd& h) {
    h = (Eigen::Matrix2d() << 1200.0 * p[0] * p[0] - 400.0 * p[1] + 2.0, -400.0 * p[0],
         -400.0 * p[0], 200.0)
            .finished();
    return true;
  };
  known.start = Eigen::Vector2d(-1.2, 1.0);
  known.answer = Eigen::Vector2d(0.8, 0.64);
  return known;
}

Known convex_quartic() {
  const Eigen::VectorXd c = Eigen::VectorXd::LinSpaced(6, -2.0, 2.0);
  Known known;
  known.problem.lower = Eigen::VectorXd::Constant(6, -std::numeric_limits<double>::infinity());
  known.problem.upper = Eigen::VectorXd::Constant(6, std::numeric_limits<double>::infinity());
  known.problem.value = [c](const Eigen::VectorXd& p) {
    const Eigen::ArrayXd s = (p - c).array().square();
    return std::optional((s * s + s).sum());
  };
  known.problem.gradient = [c](const Eigen::VectorXd& p, Eigen::VectorXd& g) {
    const Eigen::ArrayXd d = (p - c).array();
    g = 4.0 * d.cube() + 2.0 * d;
    return true;
  };
  known.problem.hessian = [c](const Eigen::VectorXd& p, Eigen::MatrixXd& h) {
    h = (12.0 * (p - c).array().square() + 2.0).matrix().asDiagonal();
    return true;
  };
  known.start = Eigen::VectorXd::Constant(6, 4.0);
  known.answer = c;
  return known;
}

Known with_an_edge(const Eigen::Vector2d& c, std::optional<double> missing) {
  Known known;
  known.problem.lower = Eigen::Vector2d::Constant(-5.0);
  known.problem.upper = Eigen::Vector2d::Constant(5.0);
  known.problem.value = [c, missing](const Eigen::VectorXd& p) {
    const double s = (p - c).squaredNorm();
    return p.sum() < 1.0 ? std::optional(s * s + s) : missing;
  };
  known.problem.gradient = [c](const Eigen::VectorXd& p, Eigen::VectorXd& g) {
    g = (4.0 * (p - c).squaredNorm() + 2.0) * (p - c);
    return true;
  };
  known.problem.hessian = [c](const Eigen::VectorXd& p, Eigen::MatrixXd& h) {
    const Eigen::Vector2d d = p - c;
    h = (4.0 * d.squaredNorm() + 2.0) * Eigen::Matrix2d::Identity() + 8.0 * d * d.transpose();
    return true;
  };
  known.start = Eigen::Vector2d(-2.0, -3.0);
  known.answer = c;
  return known;
}

}  // namespace tencer::optimize::test
