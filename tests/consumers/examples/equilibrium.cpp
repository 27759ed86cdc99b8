#include <iostream>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>

int main() {
  using namespace tencer;
  model::Structure bow;  // a rod 1 long with EI = 1, its ends drawn together by a string
  bow.rods = {{.section = {.EA = 1e6, .EI1 = 1, .EI2 = 1, .GJ = 1},
               .rest_lengths = Eigen::VectorXd::Constant(40, 1.0 / 40)}};
  bow.cables = {
      {.a = springs::OnRod{0, 0}, .b = springs::OnRod{0, 1}, .stiffness = 100, .rest_length = 0.7}};
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, 41);
  for (int i = 0; i <= 40; ++i) x.col(i) << i / 40.0, 0.1 * i / 40.0 * (1 - i / 40.0), 0;
  const equilibrium::System system(bow);
  const auto result = equilibrium::solve(system, model::make_state(bow, {x}));
  std::cout << equilibrium::describe(result.reason) << ", residual " << result.residual << '\n';
  return result.usable() && equilibrium::stability(system, result.state).stable() ? 0 : 1;
}
