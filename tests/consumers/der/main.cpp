// The bending energy of a straight rod closed into a ring is pi EI / R.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <tencer/core/version.hpp>
#include <tencer/der/energy.hpp>

static_assert(TENCER_VERSION_MAJOR == 0 && TENCER_VERSION_MINOR == 1, "as find_package asks for");

int main() {
  const double pi = std::numbers::pi;
  const int n = 200;
  const double radius = 0.5;
  Eigen::Matrix3Xd x(3, n);
  for (int i = 0; i < n; ++i) {
    x.col(i) << radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), 0.0;
  }
  tencer::der::Rod rod{.closed = true,
                       .section = tencer::der::solid_circle(1e9, 0.3, 1e-3),
                       .rest_lengths = Eigen::VectorXd::Constant(n, 2 * radius * std::sin(pi / n))};
  const double energy = tencer::der::energy(rod, tencer::der::make_state(rod, x));
  const double expected = pi * rod.section.EI1 / radius;
  std::printf("ring: %.6g, expected %.6g\n", energy, expected);
  return std::abs(energy / expected - 1.0) < 1e-3 ? 0 : 1;
}
