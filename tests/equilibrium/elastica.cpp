// Closed forms for straight rods between pinned ends: Euler's load and the planar elastica.
#include <catch2/catch.hpp>
#include <tencer/der/energy.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>

#include "models.hpp"

using namespace tencer;
using namespace tencer::equilibrium;

namespace {

model::Structure pinned_rod(int vertices) {
  model::Structure structure;
  structure.rods = {models::slender_rod(false, vertices, 1.0)};
  structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = vertices - 1}};
  return structure;
}

// The compression at which the straight state loses stability.
double buckling_load(int vertices) {
  const System system(pinned_rod(vertices));
  const double EA = system.structure().rods[0].section.EA;
  double stable = 0;
  double unstable = 40;
  while (unstable - stable > 1e-9) {
    const double load = (stable + unstable) / 2;
    const model::State state =
        model::make_state(system.structure(), {models::straight(vertices, 1 - load / EA)});
    (stability(system, state).stable() ? stable : unstable) = load;
  }
  return stable;
}

// Largest deflection of the buckled rod whose ends are `distance` apart.
double deflection(int vertices, double distance, double& load) {
  const System system(pinned_rod(vertices));
  Eigen::Matrix3Xd x = models::straight(vertices, distance);
  for (int i = 0; i < vertices; ++i)
    x(1, i) = 0.1 * std::sin(std::numbers::pi * x(0, i) / distance);
  const Equilibrium result = solve(system, model::make_state(system.structure(), {x}));
  REQUIRE(result.usable());
  load = -system.internal_forces(result.state).axial[0][vertices / 2];
  return result.state[0].x.row(1).maxCoeff();
}

}  // namespace

TEST_CASE("a straight rod buckles at Euler's load, to second order") {
  const double euler = std::numbers::pi * std::numbers::pi;
  const double coarse = buckling_load(21) / euler - 1;
  const double fine = buckling_load(41) / euler - 1;
  CHECK(std::abs(fine) < 1e-3);
  CHECK(std::log2(std::abs(coarse / fine)) == Approx(2).margin(0.05));
}

TEST_CASE("a buckled rod takes the shape of the elastica, to second order") {
  // Wang 1981: with modulus k = sin(end slope / 2), load 4 K^2, distance 2 E / K - 1, height k / K.
  const double k = std::sin(std::numbers::pi / 6);
  const double K = std::comp_ellint_1(k);
  const double distance = 2 * std::comp_ellint_2(k) / K - 1;
  std::vector<double> height_error, load_error;
  for (int vertices : {21, 41, 81}) {
    double load = 0;
    height_error.push_back(deflection(vertices, distance, load) / (k / K) - 1);
    load_error.push_back(load / (4 * K * K) - 1);
  }
  CHECK(std::abs(height_error[2]) < 2e-4);
  CHECK(std::log2(std::abs(height_error[1] / height_error[2])) == Approx(2).margin(0.1));
  CHECK(std::abs(load_error[2]) < 2e-3);
  CHECK(std::log2(std::abs(load_error[1] / load_error[2])) == Approx(2).margin(0.1));
}

TEST_CASE("a free straight rod's softest mode is the free-free beam's") {
  // (beta L)^4 with cos(beta L) cosh(beta L) = 1.
  model::Structure structure;
  structure.rods = {models::slender_rod(false, 161, 1.0)};
  const System system(structure);
  const auto result = stability(system, model::make_state(structure, {models::straight(161, 1.0)}));
  CHECK(result.stable());
  CHECK(result.smallest_eigenvalue == Approx(500.5639).epsilon(1e-3));
}
