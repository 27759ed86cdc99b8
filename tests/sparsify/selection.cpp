#include "selection.hpp"

#include <catch2/catch.hpp>
#include <tencer/symmetry/orbit.hpp>

#include "models.hpp"

using namespace tencer;
using namespace tencer::sparsify;
using namespace tencer::sparsify::test;

TEST_CASE("Few orbits of a trefoil's symmetry hold it near its shape") {
  const Model model = trefoil(48);
  const Network bare{model.structure, equilibrium::make_state(model.structure, model.positions)};
  const sensitivity::Target target{.points = model.positions};
  const symmetry::Group group = group_of(model);
  REQUIRE(group.order() == 6);
  const auto possible = candidates(model.structure, model.positions, {}).value();
  Effort effort;
  const auto networks = select_few(bare, target, possible, group, 15, {}, effort);
  REQUIRE(networks.size() >= 2);
  CHECK(cables(networks.front()) <= 6);
  int fewer = 0;
  for (const Network& network : networks) {
    CAPTURE(cables(network));
    CHECK(cables(network) > fewer);
    CHECK(cables(network) <= 15);
    fewer = cables(network);
    CHECK(idle_cables(network).empty());
    CHECK(symmetry::complete(network.structure.cables, group, 1e-3).size() ==
          network.structure.cables.size());
    const equilibrium::System system(network.structure);
    const auto again = equilibrium::solve(system, network.state);
    REQUIRE(again.usable());
    CHECK(again.iterations <= 2);
    CHECK(sensitivity::deviation(target, again.state).max_percent < 8);
  }
  // More cables come closer, if not every time.
  CHECK(sensitivity::deviation(target, networks.back().state).max_percent <
        0.5 * sensitivity::deviation(target, networks.front().state).max_percent);
  CHECK(effort.solves > 0);
}

TEST_CASE("No set of few has more cables than are wanted") {
  const Model model = trefoil(48);
  const Network bare{model.structure, equilibrium::make_state(model.structure, model.positions)};
  const auto possible = candidates(model.structure, model.positions, {}).value();
  Effort effort;
  for (const Network& network :
       select_few(bare, {.points = model.positions}, possible, group_of(model), 6, {}, effort))
    CHECK(cables(network) <= 6);
}
