#include <cmath>
#include <iostream>
#include <tencer/symmetry/detect.hpp>

int main() {
  using namespace tencer;
  geometry::Polyline curve{.points = Eigen::Matrix3Xd(3, 90), .closed = true};
  for (int i = 0; i < 90; ++i) {
    const double t = 2 * M_PI * i / 90;  // a trefoil
    curve.points.col(i) << std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
        -std::sin(3 * t);
  }
  const symmetry::Figure figure{.curves = {curve},
                                .rods = {{geometry::edge_lengths(curve), curve.closed}}};
  std::cout << symmetry::detect(figure).group.order() << " operations\n";
  return symmetry::detect(figure).group.order() == 6 ? 0 : 1;
}
