// Twisted rings and twisted straight rods leave their simple shapes where theory says.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>

#include "fixtures/second_order.hpp"
#include "models.hpp"

using namespace tencer;
using std::numbers::pi;

namespace {

constexpr double EI = 1.0;
constexpr double GJ = 0.8;
const der::Section section{.EA = 1e6, .EI1 = EI, .EI2 = EI, .GJ = GJ};

// Where the smallest eigenvalue changes sign, by bisection between a stable and an unstable angle.
template <class Smallest>
double critical_angle(double stable, double unstable, const Smallest& smallest) {
  REQUIRE(smallest(stable) > 0);
  REQUIRE(smallest(unstable) < 0);
  while (unstable - stable > 1e-5 * unstable) {
    const double angle = (stable + unstable) / 2;
    (smallest(angle) > 0 ? stable : unstable) = angle;
  }
  return stable;
}

// A closed rod of length 2 pi, glued after `angle` of twist.
model::Structure twisted_ring(int n, double angle) {
  return {.rods = {{.closed = true,
                    .section = section,
                    .rest_lengths = Eigen::VectorXd::Constant(n, 2 * pi / n),
                    .closing_angle = angle}}};
}

double ring_eigenvalue(int n, double angle) {
  auto structure = twisted_ring(n, angle);
  structure.planar = true;  // the flat ring, in balance also when unstable in space
  const equilibrium::System flat(structure);
  const auto state =
      equilibrium::solve(flat, model::make_state(structure, {models::polygon(n, 2 * pi)}));
  REQUIRE(state.usable());
  const auto stability =
      equilibrium::stability(equilibrium::System(twisted_ring(n, angle)), state.state);
  REQUIRE(stability.computed);
  CHECK((stability.negative == 0) == (stability.smallest_eigenvalue > 0));
  return stability.smallest_eigenvalue;
}

const double michell = 2 * pi * std::sqrt(3.0) * EI / GJ;

// A straight rod of n edges between two clamped edges, one turned against the other.
struct TwistedRod {
  model::Structure structure;
  model::State state;
};

TwistedRod twisted_rod(int n, double angle) {
  // The clamps' faces are the midpoints of the outer edges, a distance 1 apart.
  const double edge = 1.0 / (n - 1);
  der::Rod rod{.section = section,
               .rest_lengths = Eigen::VectorXd::Constant(n, edge),
               .clamp_start_frame = true,
               .clamp_end_frame = true};
  model::Structure structure{.rods = {rod}};
  for (int vertex : {0, 1, n - 1, n}) structure.pins.push_back({.rod = 0, .vertex = vertex});
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, n + 1);
  x.row(0).setLinSpaced(-edge / 2, 1 + edge / 2);
  auto state = model::make_state(structure, {x});
  state[0].theta.setLinSpaced(0.0, angle);
  return {structure, state};
}

double rod_eigenvalue(int n, double angle) {
  const TwistedRod rod = twisted_rod(n, angle);
  const equilibrium::System system(rod.structure);
  REQUIRE(equilibrium::residual(system, rod.state) < 1e-7);
  const auto stability = equilibrium::stability(system, rod.state);
  REQUIRE(stability.computed);
  return stability.smallest_eigenvalue;
}

}  // namespace

TEST_CASE("a ring leaves its plane at Michell's closing angle") {
  const auto error = [](int n) {
    const auto smallest = [&](double angle) { return ring_eigenvalue(n, angle); };
    return critical_angle(0.9 * michell, 1.2 * michell, smallest) / michell - 1;
  };
  check_second_order(error, 30, 0.02);
}

TEST_CASE("past Michell's angle a ring writhes until two turns of twist are gone") {
  const int n = 60;
  const auto settle = [&](double angle, double bump) {
    const auto structure = twisted_ring(n, angle);
    const equilibrium::System system(structure);
    Eigen::Matrix3Xd x = models::polygon(n, 2 * pi);
    for (int i = 0; i < n; ++i) x(2, i) += bump * std::cos(4 * pi * i / n);
    auto result = equilibrium::solve(system, model::make_state(structure, {x}));
    REQUIRE(result.usable());
    CHECK(equilibrium::stability(system, result.state).stable());
    return result;
  };
  const auto below = settle(0.95 * michell, 0.01);
  CHECK(below.state[0].holonomy == Approx(0.0).margin(1e-8));
  CHECK(below.energy == Approx(settle(0.95 * michell, 0.0).energy).epsilon(1e-9));
  // Nothing in the model keeps the ring from passing through itself, which trades two turns of
  // twist for a holonomy of 4 pi and leaves a flat ring again.
  const auto above = settle(1.1 * michell, 0.01);
  CHECK(above.state[0].holonomy == Approx(4 * pi).epsilon(1e-8));
  CHECK(above.energy == Approx(settle(1.1 * michell - 4 * pi, 0.0).energy).epsilon(1e-9));
}

TEST_CASE("a straight rod between clamps buckles at Greenhill's angle") {
  // Greenhill 1883, built-in ends without thrust: GJ angle / L = 2 x 4.4934 EI / L, tan x = x.
  const double greenhill = 2 * 4.493409457909064 * EI / GJ;
  const auto error = [&](int n) {
    const auto smallest = [&](double angle) { return rod_eigenvalue(n, angle); };
    return critical_angle(0.5 * greenhill, 2 * greenhill, smallest) / greenhill - 1;
  };
  check_second_order(error, 20, 0.006);
}
