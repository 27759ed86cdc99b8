#include <iostream>
#include <tencer/der/energy.hpp>

int main() {
  using namespace tencer::der;
  const Rod rod{.section = solid_circle(4e6, 0.3, 0.1),  // E in N/cm^2, radius in cm
                .rest_lengths = Eigen::VectorXd::Constant(20, 1.0)};
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, rod.vertices());
  for (int i = 0; i < rod.vertices(); ++i) x.col(i) << i, 0.01 * i * i, 0;
  const double stored = energy(rod, make_state(rod, x));
  std::cout << stored << " N cm\n";
  return stored > 0 ? 0 : 1;
}
