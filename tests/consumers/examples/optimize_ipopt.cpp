#include <iostream>
#include <tencer/optimize_ipopt/backends.hpp>

int main() {
  using namespace tencer;
  optimize::Problem problem;  // |p|^2 in two variables
  problem.lower = Eigen::VectorXd::Constant(2, -1);
  problem.upper = Eigen::VectorXd::Constant(2, 1);
  problem.value = [](const Eigen::VectorXd& p) { return p.squaredNorm(); };
  problem.gradient = [](const Eigen::VectorXd& p, Eigen::VectorXd& g) {
    g = 2 * p;
    return true;
  };
  for (const optimize::Backend& backend : optimize_ipopt::backends()) {
    const auto report = backend.minimise(problem, Eigen::VectorXd::Constant(2, 0.5), {});
    std::cout << backend.name << ": " << report.message << '\n';
    if (!report.usable || report.point.norm() > 1e-3) return 1;
  }
}
