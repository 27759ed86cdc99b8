// A straight rod closed along an ellipse springs back to a circle.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <tencer/der/energy.hpp>
#include <tencer/equilibrium/solve.hpp>

int main() {
  const double pi = std::numbers::pi;
  const int n = 60;
  Eigen::Matrix3Xd x(3, n);
  for (int i = 0; i < n; ++i) {
    x.col(i) << 1.3 * std::cos(2 * pi * i / n), 0.8 * std::sin(2 * pi * i / n), 0.0;
  }
  const tencer::model::Structure structure{
      .rods = {{.closed = true,
                .section = tencer::der::solid_circle(1e9, 0.3, 1e-2),
                .rest_lengths = Eigen::VectorXd::Constant(n, 0.1)}}};
  const tencer::equilibrium::System system(structure);
  const auto result = tencer::equilibrium::solve(system, tencer::model::make_state(structure, {x}));

  const Eigen::Matrix3Xd& ring = result.state[0].x;
  const Eigen::RowVectorXd radii = (ring.colwise() - ring.rowwise().mean()).colwise().norm();
  std::printf("%s; radius %.6g to %.6g\n", tencer::equilibrium::describe(result.reason).c_str(),
              radii.minCoeff(), radii.maxCoeff());
  return result.usable() && radii.maxCoeff() - radii.minCoeff() < 1e-6 ? 0 : 1;
}
