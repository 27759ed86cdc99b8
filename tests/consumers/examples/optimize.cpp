#include <iostream>
#include <tencer/optimize/gauss_newton.hpp>

int main() {
  using namespace tencer::optimize;
  Problem problem;  // (p - 3)^2 between 0 and 2
  problem.lower = Eigen::VectorXd::Constant(1, 0);
  problem.upper = Eigen::VectorXd::Constant(1, 2);
  problem.value = [](const Eigen::VectorXd& p) { return (p[0] - 3) * (p[0] - 3); };
  problem.gradient = [](const Eigen::VectorXd& p, Eigen::VectorXd& g) {
    g = 2 * (p.array() - 3);
    return true;
  };
  problem.hessian = [](const Eigen::VectorXd&, Eigen::MatrixXd& h) {
    h = Eigen::MatrixXd::Constant(1, 1, 2);
    return true;
  };
  const Report report = gauss_newton().minimise(problem, Eigen::VectorXd::Ones(1), {});
  std::cout << report.message << ": " << report.point << '\n';
  return report.usable && report.point[0] == 2 ? 0 : 1;
}
