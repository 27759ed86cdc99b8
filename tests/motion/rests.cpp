// Poses that structures rest in and the passes between them: what is known of arches and rings.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/equilibrium/stationary.hpp>
#include <tencer/motion/rests.hpp>

#include "fixtures/bow.hpp"

using namespace tencer;
using std::numbers::pi;

namespace {

// A rod of length 1 and EI 1 between hinges in the plane, bent up to the elastica of modulus k.
fixtures::Held hinged_arch(double k) {
  constexpr int vertices = 41;
  const double span = 2 * std::comp_ellint_2(k) / std::comp_ellint_1(k) - 1;
  model::Structure structure{.rods = {fixtures::slender_rod(vertices - 1, 1.0)},
                             .pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = vertices - 1}},
                             .planar = true};
  Eigen::Matrix3Xd x = fixtures::straight(vertices, span);
  for (int i = 0; i < vertices; ++i) x(1, i) = k / 2 * std::sin(pi * x(0, i) / span);
  return fixtures::settled(structure, x);
}

// Its energy: bending moments are elliptic cosines.
double arch_energy(double k) {
  const double first = std::comp_ellint_1(k);
  return 8 * first * (std::comp_ellint_2(k) - (1 - k * k) * first);
}

}  // namespace

TEST_CASE("an arch between hinges goes to its mirror image over the second elastica") {
  for (const double k : {0.1, 0.3}) {
    const auto held = hinged_arch(k);
    const auto found =
        motion::find_rests(held.structure, held.state, held.tensions, {.directions = 8});
    REQUIRE(found.finished);
    REQUIRE(found.rests.size() == 2);
    const double energy = arch_energy(k);
    for (const auto& rest : found.rests) {
      CHECK(rest.energy == Approx(energy).epsilon(2e-3));
      CHECK(rest.softest > 0);
      CHECK(rest.found > 0);
    }
    CHECK((found.rests[1].state[0].x.row(1) + found.rests[0].state[0].x.row(1)).norm() < 1e-4);
    // The second elastica is two arches half as long and high: four times the energy.
    REQUIRE(found.passes.size() >= 1);
    const motion::Pass& pass = found.passes[0];
    CHECK(pass.energy == Approx(4 * energy).epsilon(1e-2));
    CHECK(pass.free());
    CHECK(std::min(pass.from, pass.to) == 0);
    CHECK(std::max(pass.from, pass.to) == 1);
    // Steepest descent on both sides.
    REQUIRE(pass.top > 0);
    for (int i = 0; i + 1 < static_cast<int>(pass.way.size()); ++i) {
      const double rise = pass.way[static_cast<std::size_t>(i) + 1].energy -
                          pass.way[static_cast<std::size_t>(i)].energy;
      INFO(i << " of " << pass.top);
      CHECK((i < pass.top ? rise : -rise) > -1e-6 * energy);
    }
    CHECK(motion::lowest_ways(found, 0) == std::vector<std::vector<int>>{{}, {0}});
  }
}

TEST_CASE("a ring rests as a circle only, and what no push leads out of has no passes") {
  constexpr int count = 40;
  model::Structure ring;
  ring.rods = {fixtures::slender_rod(count, 1.0)};
  ring.rods[0].closed = true;
  Eigen::Matrix3Xd x(3, count);
  for (int i = 0; i < count; ++i)
    x.col(i) << std::cos(2 * pi * i / count) / (2 * pi), std::sin(2 * pi * i / count) / (2 * pi), 0;
  const auto held = fixtures::settled(ring, x);
  const motion::RestsOptions options{.directions = 6};
  const auto found = motion::find_rests(held.structure, held.state, held.tensions, options);
  REQUIRE(found.rests.size() == 1);
  CHECK(found.passes.empty());
  CHECK(found.rests[0].energy == Approx(2 * pi * pi).epsilon(5e-3));
  CHECK(found.rests[0].found + found.lost == found.pushes);
  CHECK(found.pushes == 12);
}

TEST_CASE("the equilibrium next to the second elastica is unstable in one direction") {
  // Two arches half as long, one up and one down, put together roughly.
  const auto held = hinged_arch(0.3);
  const Eigen::Matrix3Xd& arch = held.state[0].x;
  const auto last = arch.cols() - 1;
  Eigen::Matrix3Xd x = arch;
  for (Eigen::Index i = 0; i <= last / 2; ++i) {
    x.col(i) = arch.col(2 * i) / 2;
    x.col(last - i) = arch.col(last) - x.col(i);
  }
  const auto near = model::make_state(held.structure, {x});
  equilibrium::InternalForces forces{.axial = {Eigen::VectorXd::Constant(last, -4 * pi * pi)},
                                     .tension = held.tensions};
  const auto found = equilibrium::stationary_near(held.structure, near, forces, 1.0);
  REQUIRE(found);
  CHECK(found->negative == 1);
  const equilibrium::System system(held.structure);
  CHECK(system.energy(found->state) == Approx(4 * arch_energy(0.3)).epsilon(1e-2));
  const auto stable = equilibrium::stationary_near(held.structure, held.state,
                                                   system.internal_forces(held.state), 0.1);
  REQUIRE(stable);
  CHECK(stable->negative == 0);
}

TEST_CASE("the way with the lowest pass is the one that is told") {
  motion::Rests found{.rests = std::vector<motion::Rest>(5)};
  // In order of their energies: 0 to 2 goes by 1, over 2 at most; nothing leads to 4.
  for (const auto& [from, to] :
       {std::pair(1, 2), std::pair(1, 0), std::pair(2, 0), std::pair(3, 2)})
    found.passes.push_back({.from = from, .to = to});
  CHECK(motion::lowest_ways(found, 0) ==
        std::vector<std::vector<int>>{{}, {1}, {1, 0}, {1, 0, 3}, {}});
}
