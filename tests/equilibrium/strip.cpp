// Rods with material frames in equilibrium.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/der/energy.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>

#include "models.hpp"

using namespace tencer;
using std::numbers::pi;

namespace {

model::Structure strip(int n) {
  return {.rods = {{.closed = true,
                    .section = {.EA = 1e5, .EI1 = 4.0, .EI2 = 1.0, .GJ = 1.5},
                    .rest_lengths = Eigen::VectorXd::Constant(n, 2 * pi / n)}}};
}

}  // namespace

TEST_CASE("a strip closed to a ring turns to bend about its weak axis") {
  const int n = 40;
  auto structure = strip(n);
  if (GENERATE(false, true)) structure.rods[0].closing_angle = 0.0;
  auto start = model::make_state(structure, {models::polygon(n, 2 * pi)});
  // Far from the weak axis (m1 in the plane), and unevenly so.
  for (int j = 0; j < n; ++j) {
    const Eigen::Vector3d t = start[0].frames.tangent.col(j);
    const double tilt = 1.2 + 0.2 * std::sin(6 * pi * j / n);
    der::set_material_frame(start[0], j,
                            std::cos(tilt) * t.cross(Eigen::Vector3d::UnitZ()) +
                                std::sin(tilt) * Eigen::Vector3d::UnitZ());
  }
  const equilibrium::System system(structure);
  const auto result = equilibrium::solve(system, start);
  REQUIRE(result.usable());
  CHECK(equilibrium::stability(system, result.state).stable());

  auto isotropic = structure;
  isotropic.rods[0].section.EI1 = isotropic.rods[0].section.EI2;
  const equilibrium::System plain(isotropic);
  const auto ring =
      equilibrium::solve(plain, model::make_state(isotropic, {models::polygon(n, 2 * pi)}));
  CHECK(result.energy == Approx(ring.energy).epsilon(1e-10));
}

TEST_CASE("a strip bent at rest springs back to its rest shape") {
  const int n = 30;
  Eigen::Matrix3Xd helix(3, n);
  for (int i = 0; i < n; ++i) helix.col(i) << std::cos(0.3 * i), std::sin(0.3 * i), 0.1 * i;
  der::Rod rod{.section = {.EA = 1e5, .EI1 = 4.0, .EI2 = 1.0, .GJ = 1.5}};
  const Eigen::Matrix3Xd m1 = Eigen::Vector3d::UnitZ().replicate(1, n - 1);
  der::set_rest_shape(rod, helix, m1);
  const model::Structure structure{.rods = {rod}};
  Eigen::Matrix3Xd bent = helix;
  bent.row(2) *= 0.7;
  bent.row(0) *= 1.2;
  const equilibrium::System system(structure);
  const auto result = equilibrium::solve(system, model::make_state(structure, {bent}));
  REQUIRE(result.usable());
  CHECK(result.energy < 1e-12);
  CHECK(equilibrium::stability(system, result.state).stable());
  // Distances along the rod are those at rest.
  for (int gap : {2, 3, 10, n - 1})
    CHECK((result.state[0].x.col(gap) - result.state[0].x.col(0)).norm() ==
          Approx((helix.col(gap) - helix.col(0)).norm()).epsilon(1e-7));
}

TEST_CASE("a straight strip may turn about itself, and nothing else is singular") {
  const int n = 80;
  der::Rod rod{.section = {.EA = 1e5, .EI1 = 4.0, .EI2 = 1.0, .GJ = 1.5},
               .rest_lengths = Eigen::VectorXd::Constant(n, 1.0 / n)};
  model::Structure structure{.rods = {rod}};
  if (GENERATE(false, true)) structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = n}};
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, n + 1);
  x.row(0).setLinSpaced(0, 1);
  const auto result =
      equilibrium::solve(equilibrium::System(structure), model::make_state(structure, {x}));
  CHECK(result.usable());
  const auto stability = equilibrium::stability(equilibrium::System(structure), result.state);
  CHECK(stability.stable());
  // Free: the free-free beam's mode about the soft axis, in units of the larger EI; pinned: pi^4.
  const double expected = structure.pins.empty() ? 500.5639 / 4 : std::pow(pi, 4) / 4;
  CHECK(stability.smallest_eigenvalue == Approx(expected).epsilon(0.01));
}
