#include <iostream>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/motion/actuate.hpp>

int main() {
  using namespace tencer;
  model::Structure bow;
  bow.rods = {{.section = {.EA = 1e6, .EI1 = 1, .EI2 = 1, .GJ = 1},
               .rest_lengths = Eigen::VectorXd::Constant(20, 1.0 / 20)}};
  bow.cables = {{.a = springs::OnRod{0, 0}, .b = springs::OnRod{0, 1}, .rest_length = 0.8}};
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, 21);
  for (int i = 0; i <= 20; ++i) x.col(i) << i / 20.0, 0.4 * i / 20.0 * (1 - i / 20.0), 0;
  const auto rest = equilibrium::relax_inextensible(bow, model::make_state(bow, {x}));
  const auto found = motion::actuate(bow, rest.equilibrium.state, rest.tensions,
                                     {{.lengths = Eigen::VectorXd::Constant(1, 0.4)}});
  std::cout << "drawn to half its length the string pulls with " << found.frames.back().tensions[0]
            << " instead of " << rest.tensions[0] << ", after " << found.jumps.size() << " jumps\n";
  return found.finished && found.jumps.empty() ? 0 : 1;
}
