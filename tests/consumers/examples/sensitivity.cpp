#include <iostream>
#include <tencer/sensitivity/derivatives.hpp>

int main() {
  using namespace tencer;
  model::Structure bow;
  bow.rods = {{.section = {.EA = 1e6, .EI1 = 1, .EI2 = 1, .GJ = 1},
               .rest_lengths = Eigen::VectorXd::Constant(20, 1.0 / 20)}};
  bow.cables = {
      {.a = springs::OnRod{0, 0}, .b = springs::OnRod{0, 1}, .stiffness = 100, .rest_length = 0.7}};
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, 21);
  for (int i = 0; i <= 20; ++i) x.col(i) << i / 20.0, 0.4 * i / 20.0 * (1 - i / 20.0), 0;
  const sensitivity::Tracker tracker(bow, model::make_state(bow, {x}));
  const auto& at = tracker.committed();
  const sensitivity::Distance distance(model::make_target(bow, {x}), at.system, at.state);
  const springs::Parameter length{springs::ParameterKind::rest_length, 0};
  std::cout << "the distance from the arc grows by "
            << sensitivity::gradient(at, {&length, 1}, sensitivity::adjoint(at, distance))
            << " per length of string\n";
  return tracker.first().usable() ? 0 : 1;
}
