// Frequencies against closed forms.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/certify/modes.hpp>
#include <tencer/equilibrium/inextensible.hpp>

#include "fixtures/bow.hpp"

using namespace tencer;
using Catch::Matchers::WithinRel;

namespace {

// omega sqrt(m L^4 / EI) of the lowest mode of a straight rod with EI, m and L other than 1.
double straight_rod(int edges, bool clamped) {
  constexpr double EI = 3, mass = 0.7, length = 2;
  model::Structure rod;
  rod.rods = {fixtures::slender_rod(edges, length)};
  rod.rods[0].section.EI1 = rod.rods[0].section.EI2 = EI;
  if (clamped) rod.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 1}};
  const auto modes =
      certify::vibration_modes(rod, model::make_state(rod, {fixtures::straight(edges + 1, length)}),
                               Eigen::VectorXd(0), Eigen::VectorXd::Constant(1, mass));
  REQUIRE(modes.computed);
  REQUIRE(modes.hertz.size() == 10);
  // A clamp is felt in the middle of the edge that is held.
  const double free_length = clamped ? length * (1 - 0.5 / edges) : length;
  // Bending is the same in all planes across the rod.
  CHECK_THAT(modes.hertz[1], WithinRel(modes.hertz[0], 1e-6));
  return 2 * std::numbers::pi * modes.hertz[0] * std::sqrt(mass * std::pow(free_length, 4) / EI);
}

}  // namespace

TEST_CASE("a free rod sounds as the closed form says, in second order") {
  const double coarse = straight_rod(40, false) - 22.373285;
  const double fine = straight_rod(80, false) - 22.373285;
  CHECK(std::abs(fine) < 5e-3 * 22.373);
  CHECK_THAT(coarse / fine, WithinRel(4.0, 0.1));
}

TEST_CASE("a clamped rod sounds as the closed form says") {
  CHECK_THAT(straight_rod(100, true), WithinRel(3.516015, 1e-3));
}

TEST_CASE("a ring in its plane sounds as the closed form says, and its lowest modes are two") {
  constexpr int vertices = 120;
  model::Structure ring;
  ring.rods = {fixtures::slender_rod(vertices, 1.0)};
  ring.rods[0].closed = true;
  ring.planar = true;
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, vertices);
  const double radius = 1.0 / vertices / (2 * std::sin(std::numbers::pi / vertices));
  for (int i = 0; i < vertices; ++i)
    x.col(i).head<2>() << radius * std::cos(2 * std::numbers::pi * i / vertices),
        radius * std::sin(2 * std::numbers::pi * i / vertices);
  const auto modes = certify::vibration_modes(ring, model::make_state(ring, {x}),
                                              Eigen::VectorXd(0), Eigen::VectorXd::Ones(1), 4);
  REQUIRE(modes.computed);
  const auto omega = [&](double n) {
    return n * (n * n - 1) / std::sqrt(n * n + 1) / (radius * radius);
  };
  for (const int mode : {0, 1})
    CHECK_THAT(2 * std::numbers::pi * modes.hertz[mode], WithinRel(omega(2), 2e-3));
  for (const int mode : {2, 3})
    CHECK_THAT(2 * std::numbers::pi * modes.hertz[mode], WithinRel(omega(3), 5e-3));
}

TEST_CASE("modes keep the lengths of cables, and cables make them faster") {
  const auto [structure, state, tensions] = fixtures::bow();
  const auto modes = certify::vibration_modes(structure, state, tensions, Eigen::VectorXd::Ones(1));
  REQUIRE(modes.computed);
  const equilibrium::System system(structure);
  for (Eigen::Index m = 0; m < modes.hertz.size(); ++m) {
    CHECK(modes.hertz[m] > 0);
    const auto& moved = modes.shapes[m][0];
    CHECK(std::abs(moved.cwiseAbs().maxCoeff() - 1) < 1e-12);
    for (const auto& stencil : system.stencils()) {
      const Eigen::Vector3d t = model::span_of(stencil, state).normalized();
      double longer = 0;
      for (int i = 0; i < stencil.count; ++i)
        longer += stencil.shares[i].weight * t.dot(moved.col(stencil.shares[i].vertex));
      CHECK(std::abs(longer) < 1e-7);
    }
  }
  const auto heavier =
      certify::vibration_modes(structure, state, tensions, Eigen::VectorXd::Constant(1, 4.0));
  CHECK_THAT(heavier.hertz[0], WithinRel(modes.hertz[0] / 2, 1e-6));
}

TEST_CASE("masses must be given for every rod and be positive") {
  const auto [structure, state, tensions] = fixtures::bow();
  for (const auto& mass : {Eigen::VectorXd(0), Eigen::VectorXd(Eigen::VectorXd::Zero(1))})
    CHECK_THROWS_AS(certify::vibration_modes(structure, state, tensions, mass),
                    std::invalid_argument);
}
