#include <iostream>
#include <tencer/linalg/symmetric_factor.hpp>

int main() {
  using namespace tencer::linalg;
  SymmetricMatrix a(2, 2);  // the lower triangle of [2 1; 1 -3]
  a.insert(0, 0) = 2;
  a.insert(1, 0) = 1;
  a.insert(1, 1) = -3;
  a.makeCompressed();
  SymmetricFactor factor;
  if (!factor.factorise(a)) return 1;
  std::cout << factor.inertia().negative << " negative eigenvalue\n";
  return (factor.solve(Eigen::Vector2d(3, -2)) - Eigen::Vector2d(1, 1)).norm() < 1e-12 ? 0 : 1;
}
