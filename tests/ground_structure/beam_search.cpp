#include <catch2/catch.hpp>
#include <tencer/ground_structure/beam_search.hpp>
#include <tencer/symmetry/orbit.hpp>

#include "fixtures/problems.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using ground_structure::beam_search;

TEST_CASE("Few orbits of a trefoil's symmetry hold it near its shape") {
  const Model model = trefoil(48);
  const auto problem = problem_of(model);
  const symmetry::Group group = group_of(model);
  REQUIRE(group.order() == 6);
  network::SolveCounts counts;
  const auto networks = beam_search(problem, group, {.max_cables = 15}, {}, counts);
  REQUIRE(networks.size() >= 2);
  CHECK(cable_count(networks.front()) <= 6);
  int fewer = 0;
  for (const network::Network& network : networks) {
    CAPTURE(cable_count(network));
    CHECK(cable_count(network) > fewer);
    CHECK(cable_count(network) <= 15);
    fewer = cable_count(network);
    CHECK(idle_cables(network).empty());
    CHECK(symmetry::complete(network.structure.cables, group, 1e-3).size() ==
          network.structure.cables.size());
    const equilibrium::System system(network.structure);
    const auto again = equilibrium::solve(system, network.state);
    REQUIRE(again.usable());
    CHECK(again.iterations <= 2);
    CHECK(sensitivity::deviation(problem.target, again.state).max_percent < 8);
  }
  // More cables come closer, if not every time.
  CHECK(sensitivity::deviation(problem.target, networks.back().state).max_percent <
        0.5 * sensitivity::deviation(problem.target, networks.front().state).max_percent);
  CHECK(counts.solves > 0);
}

TEST_CASE("No set of few has more cables than are wanted") {
  const Model model = trefoil(48);
  network::SolveCounts counts;
  for (const network::Network& network :
       beam_search(problem_of(model), group_of(model), {.max_cables = 6}, {}, counts))
    CHECK(cable_count(network) <= 6);
}
