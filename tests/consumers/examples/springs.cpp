#include <iostream>
#include <tencer/springs/cable.hpp>
#include <tencer/springs/law.hpp>

int main() {
  using namespace tencer;
  const geometry::ArcLength rod(Eigen::VectorXd::Constant(4, 1.0), false);
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, 5);
  x.row(0) << 0, 1, 2, 3, 4;
  const springs::Cable cable{
      .a = springs::OnRod{0, 0.5}, .b = springs::OnRod{0, 3.5}, .stiffness = 10, .rest_length = 2};
  const auto stencil = springs::stencil(cable, {&rod, 1}, Eigen::Matrix3Xd(3, 0));
  const Eigen::Vector3d span = springs::span_of(stencil, [&](int, int v) { return x.col(v); });
  std::cout << span.norm() << " long, pulls with " << springs::tension(cable, span.norm()) << '\n';
  return springs::tension(cable, span.norm()) == 10 ? 0 : 1;
}
