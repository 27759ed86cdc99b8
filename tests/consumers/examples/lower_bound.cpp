#include <cmath>
#include <iostream>
#include <tencer/lower_bound/at_least.hpp>

int main() {
  using namespace tencer;
  // A figure of eight that leaves its plane, of one round rod.
  constexpr int n = 120;
  Eigen::Matrix3Xd curve(3, n);
  for (int i = 0; i < n; ++i) {
    const double t = 2 * M_PI * i / n;
    curve.col(i) << 10 * std::sin(t), 6 * std::sin(2 * t), 2 * std::cos(t);
  }
  der::Rod rod{.closed = true, .section = der::solid_circle(4e6, 0.3, 0.05)};
  rod.rest_lengths.resize(n);
  for (int i = 0; i < n; ++i) rod.rest_lengths[i] = (curve.col((i + 1) % n) - curve.col(i)).norm();
  const model::Structure structure{.rods = {rod}};
  const auto found = lower_bound::at_least(structure, model::make_target(structure, {curve}), 0.1);
  std::cout << in_words(found) << '\n';
  return found.cables > 0 ? 0 : 1;
}
