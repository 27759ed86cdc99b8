#include <iostream>
#include <tencer/registration/rigid.hpp>

int main() {
  using namespace tencer::registration;
  Eigen::Matrix3Xd from(3, 3);
  from << 0, 1, 0, 0, 0, 2, 0, 0, 0;
  Eigen::Matrix3Xd to = from;
  to.row(2).array() += 5;  // the same triangle, higher up
  const RigidMotion motion = align(from, to, Eigen::VectorXd::Ones(3));
  std::cout << motion.translation.transpose() << '\n';
  return (motion.apply(from) - to).norm() < 1e-12 ? 0 : 1;
}
