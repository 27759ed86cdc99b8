#include <iostream>
#include <tencer/network/rest_length.hpp>
#include <tencer/network/stage.hpp>

int main() {
  using namespace tencer;
  model::Structure bow;
  bow.rods = {{.section = {.EA = 1e6, .EI1 = 1, .EI2 = 1, .GJ = 1},
               .rest_lengths = Eigen::VectorXd::Constant(20, 1.0 / 20)}};
  bow.cables = {
      {.a = springs::OnRod{0, 0}, .b = springs::OnRod{0, 1}, .stiffness = 100, .rest_length = 0.7}};
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, 21);
  for (int i = 0; i <= 20; ++i) x.col(i) << i / 20.0, 0.4 * i / 20.0 * (1 - i / 20.0), 0;
  const auto found = equilibrium::solve(equilibrium::System(bow), model::make_state(bow, {x}));
  const network::Network network{bow, found.state};
  std::cout << "pulls with " << network::cable_tensions(network) << ", stands with rest lengths of "
            << network::smallest_stable_rest_length(network).rest_ratio << " of the length\n";
  return network::fault_of(network) == network::Fault::none ? 0 : 1;
}
