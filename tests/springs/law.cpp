#include <catch2/catch.hpp>
#include <limits>
#include <tencer/springs/law.hpp>

namespace tencer::springs {
namespace {

Cable spring_of(double stiffness, double rest_length, bool tension_only = false) {
  return {.a = OnRod{0, 0.0},
          .b = OnRod{0, 1.0},
          .stiffness = stiffness,
          .rest_length = rest_length,
          .tension_only = tension_only};
}

}  // namespace

TEST_CASE("a spring pulls, pushes, or goes slack") {
  CHECK(tension(spring_of(3, 2), 2.5) == 1.5);
  CHECK(tension(spring_of(3, 2), 1.5) == -1.5);
  CHECK(tension(spring_of(3, 2, true), 2.5) == 1.5);
  CHECK(tension(spring_of(3, 2, true), 1.5) == 0.0);
  CHECK(energy(spring_of(3, 2), 2.5) == Approx(0.375));
  CHECK(energy(spring_of(3, 2, true), 1.5) == 0.0);
}

TEST_CASE("force and stiffness are the energy's derivatives in the span") {
  const Eigen::Vector3d d(0.8, -1.1, 0.4);
  // Stretched, compressed, of rest length zero, taut and slack.
  for (const Cable& cable : {spring_of(3, 0.9), spring_of(3, 2.2), spring_of(3, 0),
                             spring_of(3, 0.9, true), spring_of(3, 2.2, true)}) {
    constexpr double h = 1e-5;
    Eigen::Vector3d gradient;
    Eigen::Matrix3d hessian;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
      gradient[i] = (energy(cable, (d + step).norm()) - energy(cable, (d - step).norm())) / (2 * h);
      hessian.col(i) = (force(cable, d + step) - force(cable, d - step)) / (2 * h);
    }
    CHECK((force(cable, d) - gradient).norm() < 1e-8);
    CHECK((stiffness_matrix(cable, d, tension(cable, d.norm())) - hessian).norm() < 1e-8);
  }
}

TEST_CASE("a predicted tension changes the geometric stiffness only") {
  const Cable cable = spring_of(3, 0.9);
  const Eigen::Vector3d d(0, 2, 0);
  const Eigen::Matrix3d matrix = stiffness_matrix(cable, d, 5.0);
  CHECK(matrix.isApprox(Eigen::Vector3d(2.5, 3, 2.5).asDiagonal().toDenseMatrix(), 1e-15));
}

TEST_CASE("a cable without length has a force only when that is no matter of direction") {
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  CHECK(force(spring_of(3, 1), none) == none);
  CHECK(force(spring_of(3, 0), none) == none);
  CHECK(stiffness_matrix(spring_of(3, 1), none, -3) == Eigen::Matrix3d::Zero());
  CHECK(stiffness_matrix(spring_of(3, 0), none, 0) == 3 * Eigen::Matrix3d::Identity());
}

TEST_CASE("a rebased spring pulls as before") {
  const Cable cable = spring_of(3, 1.2);
  for (const double rho : {0.0, 0.5, 0.99}) {
    const Cable rebased = springs::rebased(cable, 1.7, rho);
    CHECK(rebased.rest_length == rho * 1.7);
    CHECK(tension(rebased, 1.7) == Approx(tension(cable, 1.7)).epsilon(1e-14));
  }
  CHECK_THROWS_AS(rebased(cable, 1.7, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(rebased(cable, 0.0, 0.5), std::invalid_argument);
}

TEST_CASE("unusable cables are refused") {
  const auto refused = [](Cable cable) {
    CHECK_THROWS_AS(validate(cable, 1, 1), std::invalid_argument);
  };
  CHECK_NOTHROW(validate(spring_of(3, 1), 1, 1));
  refused(spring_of(-1, 1));
  refused(spring_of(1, -1));
  refused(spring_of(std::numeric_limits<double>::quiet_NaN(), 1));
  refused(spring_of(1, std::numeric_limits<double>::infinity()));
  Cable cable = spring_of(1, 1);
  cable.a = OnRod{1, 0.0};
  refused(cable);
  cable.a = OnRod{0, std::numeric_limits<double>::quiet_NaN()};
  refused(cable);
  cable.a = AtAnchor{1};
  refused(cable);
  cable.a = AtAnchor{0};
  CHECK_NOTHROW(validate(cable, 1, 1));
  cable.b = AtAnchor{0};
  refused(cable);
}

}  // namespace tencer::springs
