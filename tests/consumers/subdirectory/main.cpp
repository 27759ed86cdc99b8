// Points that were turned a quarter and moved are laid back onto where they were.
#include <cstdio>
#include <tencer/registration/rigid.hpp>

int main() {
  const Eigen::Matrix3Xd points{{0, 1, 0, 0}, {0, 0, 2, 0}, {0, 0, 0, 3}};
  Eigen::Matrix3Xd moved(3, 4);
  moved << 5 - points.row(1).array(), points.row(0), points.row(2);
  const auto motion = tencer::registration::align(moved, points, Eigen::VectorXd::Ones(4));
  const double distance = (motion.apply(moved) - points).norm();
  std::printf("distance %.3g\n", distance);
  return distance < 1e-12 ? 0 : 1;
}
