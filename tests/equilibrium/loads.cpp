// Dead loads: closed forms of beams, and which rigid motions a load leaves free.
#include <catch2/catch.hpp>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/equilibrium/rigid_modes.hpp>

#include "fixtures/second_order.hpp"
#include "models.hpp"

using namespace tencer;
using namespace tencer::equilibrium;

namespace {

// EI = 1, length 1 from the clamp's face, which is the middle of the first edge.
model::Structure cantilever(int edges) {
  model::Structure structure;
  structure.rods = {models::slender_rod(false, edges + 1, edges / (edges - 0.5), 1e3)};
  structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 1}};
  return structure;
}

Equilibrium loaded(const model::Structure& structure) {
  const auto& rod = structure.rods[0];
  const Equilibrium result =
      solve(System(structure),
            model::make_state(structure, {models::straight(rod.vertices(), rod.length())}));
  REQUIRE(result.usable());
  const Assessment assessment = assess(structure, result.state, Eigen::VectorXd(0));
  CHECK(assessment.certified());
  return result;
}

double tip(const Equilibrium& result) {
  return -result.state[0].x(2, result.state[0].x.cols() - 1);
}

}  // namespace

TEST_CASE("a cantilever's tip sinks by w L^4 / 8 EI under its weight, to second order") {
  check_second_order(
      [](int edges) {
        model::Structure structure = cantilever(edges);
        structure.line_loads = {{.rod = 0, .force_per_length = {0, 0, -1e-3}}};
        return tip(loaded(structure)) / (1e-3 / 8) - 1;
      },
      20, 2e-3);
}

TEST_CASE("a cantilever's tip sinks by P L^3 / 3 EI under a load at the tip, to second order") {
  check_second_order(
      [](int edges) {
        model::Structure structure = cantilever(edges);
        structure.point_loads = {{.rod = 0, .s = 2, .force = {0, 0, -1e-3}}};
        return tip(loaded(structure)) / (1e-3 / 3) - 1;
      },
      20, 2e-3);
}

TEST_CASE("a point load between vertices is that on the vertices beside it") {
  model::Structure one = cantilever(20);
  const double edge = one.rods[0].rest_lengths[0];
  model::Structure two = one;
  one.point_loads = {{.rod = 0, .s = 10.25 * edge, .force = {0, 0, -1}}};
  two.point_loads = {{.rod = 0, .s = 10 * edge, .force = {0, 0, -0.75}},
                     {.rod = 0, .s = 11 * edge, .force = {0, 0, -0.25}}};
  CHECK(tip(loaded(one)) == Approx(tip(loaded(two))).epsilon(1e-9));
}

TEST_CASE("large loads: the elastica of a cantilever") {
  // Bisshopp and Drucker 1945: at P L^2 / EI = 1 the tip sinks by 0.3017 L.
  model::Structure structure = cantilever(80);
  structure.point_loads = {{.rod = 0, .s = 2, .force = {0, 0, -1}}};
  CHECK(tip(loaded(structure)) == Approx(0.3017).epsilon(1e-3));
}

TEST_CASE("the gradient with loads is that of the energy") {
  model::Structure structure = models::ring_with_cable(12, 3.0, 0.1);
  structure.pins = {{.rod = 0, .vertex = 3}};
  structure.point_loads = {{.rod = 0, .s = 0.37, .force = {0.3, -2, 5}}};
  structure.line_loads = {{.rod = 0, .force_per_length = {1, 0, -4}}};
  const System system(structure);
  model::State state = model::make_state(structure, {models::polygon(12, 1.0)});
  system.displace(state, 0.01 * Eigen::VectorXd::Random(system.size()));
  const Eigen::VectorXd gradient = system.gradient(state);
  const double h = 1e-6;
  for (int i = 0; i < system.size(); ++i) {
    const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(system.size(), i);
    const double slope = (system.energy(system.displaced(state, step)) -
                          system.energy(system.displaced(state, -step))) /
                         (2 * h);
    CHECK(gradient[i] == Approx(slope).epsilon(1e-6).margin(1e-6 * gradient.norm()));
  }
}

TEST_CASE("a load on rods that nothing holds has no equilibrium") {
  model::Structure ring = models::ring_with_cable(20, 3.0, 0.1);
  ring.line_loads = {{.rod = 0, .force_per_length = {0, 0, -1}}};
  const auto reason = [](const model::Structure& structure) {
    const Equilibrium result =
        solve(System(structure), model::make_state(structure, {models::polygon(20, 1.0)}));
    return result.usable() ? Reason::converged : result.reason;
  };
  CHECK(reason(ring) == Reason::not_held);
  model::Structure railed = ring;
  railed.pins = {{.rod = 0, .vertex = 0, .axes = {true, true, false}}};
  CHECK(reason(railed) == Reason::not_held);
  model::Structure on_a_table = ring;
  for (int vertex : {0, 6, 13})
    on_a_table.pins.push_back({.rod = 0, .vertex = vertex, .axes = {false, false, true}});
  CHECK(reason(on_a_table) == Reason::converged);
  model::Structure hung = ring;
  hung.pins = {{.rod = 0, .vertex = 0}};
  CHECK(reason(hung) == Reason::converged);
}

TEST_CASE("gravity leaves turning about the vertical free, opposite pulls sliding") {
  model::Structure ring = models::ring_with_cable(20, 3.0, 0.1);
  ring.pins = {{.rod = 0, .vertex = 0}};
  const model::State state = model::make_state(ring, {models::polygon(20, 1.0)});
  const auto free_motions = [&](const model::Structure& structure) {
    return rigid_modes(System(structure), state)[0].basis.cols();
  };
  CHECK(free_motions(ring) == 3);
  ring.line_loads = {{.rod = 0, .force_per_length = {0, 0, -1}}};
  CHECK(free_motions(ring) == 1);
  ring.point_loads = {{.rod = 0, .s = 0.2, .force = {1, 0, 0}}};
  CHECK(free_motions(ring) == 0);

  ring.pins.clear();
  ring.line_loads.clear();
  ring.point_loads = {{.rod = 0, .s = 0.0, .force = {1, 0, 0}},
                      {.rod = 0, .s = 0.5, .force = {-1, 0, 0}}};
  CHECK(free_motions(ring) == 4);
  const Equilibrium stretched = solve(System(ring), state);
  CHECK(stretched.usable());
  CHECK(stability(System(ring), stretched.state).stable());
}

TEST_CASE("a ring hung from a vertex comes to hang below it, wherever it starts") {
  model::Structure ring = models::ring_with_cable(24, 3.0, 0.1);
  ring.pins = {{.rod = 0, .vertex = 0}};
  ring.line_loads = {{.rod = 0, .force_per_length = {0, 0, -1}}};
  const Equilibrium result =
      solve(System(ring), model::make_state(ring, {models::polygon(24, 1.0)}));
  REQUIRE(result.usable());
  const Eigen::Vector3d centre = result.state[0].x.rowwise().mean() - result.state[0].x.col(0);
  CHECK(centre.head<2>().norm() < 1e-6);
  CHECK(centre.z() < -0.1);
  CHECK(stability(System(ring), result.state).stable());
}
