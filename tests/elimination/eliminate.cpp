#include <catch2/catch.hpp>
#include <tencer/elimination/eliminate.hpp>
#include <tencer/ground_structure/force_balance.hpp>
#include <tencer/symmetry/orbit.hpp>

#include "fixtures/problems.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using elimination::eliminate;
using network::Network;

namespace {

struct Balance {
  ground_structure::Problem problem{};
  Network network{};
};

Balance balance_of(const Model& model, const model::Rules& rules = {}) {
  Balance start{.problem = problem_of(model, rules)};
  start.network = ground_structure::force_balance(start.problem, nullptr).network;
  return start;
}

}  // namespace

TEST_CASE(
    "Elimination leaves few cables within the tolerance, all pulling, in stable equilibrium") {
  const Balance start = balance_of(trefoil());
  const auto result = eliminate(start.network, start.problem, {.goal = {.max_error_percent = 1.0}});
  CHECK(result.stage.valid());
  const auto deviation = sensitivity::deviation(start.problem.target, result.stage.network.state);
  CHECK(deviation.max_percent <= 1.0);
  CHECK(cable_count(result.stage.network) <= 10);
}

TEST_CASE("The number of cables asked for is not exceeded") {
  const Balance start = balance_of(trefoil());
  const auto result = eliminate(start.network, start.problem, {.goal = {.cables = 12}});
  CHECK(result.stage.valid());
  CHECK(cable_count(result.stage.network) <= 12);
  CHECK(sensitivity::deviation(start.problem.target, result.stage.network.state).max_percent < 0.5);
}

TEST_CASE("More cables are closer in the trade-off, and every network in it is valid") {
  const Balance start = balance_of(trefoil());
  const auto result = eliminate(start.network, start.problem,
                                {.goal = {.max_error_percent = 1.0, .every_number = true}});
  REQUIRE(result.solutions.size() > 4);
  for (std::size_t i = 0; i < result.solutions.size(); ++i) {
    const elimination::Solution& solution = result.solutions[i];
    CHECK(idle_cables(solution.network).empty());
    CHECK(solution.max_percent ==
          Approx(sensitivity::deviation(start.problem.target, solution.network.state).max_percent));
    if (i == 0) continue;
    CHECK(cable_count(solution.network) > cable_count(result.solutions[i - 1].network));
    CHECK(solution.max_percent < result.solutions[i - 1].max_percent);
  }
}

TEST_CASE("The result does not depend on the number of threads") {
  const Balance start = balance_of(trefoil(40));
  std::vector<Network> results;
  for (const int threads : {1, 2})
    results.push_back(eliminate(start.network, start.problem,
                                {.goal = {.max_error_percent = 2.0}, .threads = threads})
                          .stage.network);
  REQUIRE(cable_count(results[0]) == cable_count(results[1]));
  for (std::size_t r = 0; r < results[0].state.size(); ++r)
    CHECK(results[0].state[r].x == results[1].state[r].x);
}

TEST_CASE("Elimination keeps to the rules") {
  const Model model = linked_ellipses();
  model::Rules rules{.pairs = std::vector<model::RodPair>{{0, 1}}};
  rules.max_cable_length = 0.6;
  const Balance start = balance_of(model, rules);
  const auto result = eliminate(start.network, start.problem, {.goal = {.max_error_percent = 2.0}});
  CHECK(result.stage.valid());
  CHECK(cable_count(result.stage.network) < cable_count(start.network));
  CHECK(cable_lengths(result.stage.network).maxCoeff() <= 0.6 * (1 + 1e-9));
  for (const auto& cable : result.stage.network.structure.cables)
    CHECK(std::get<springs::OnRod>(cable.a).rod != std::get<springs::OnRod>(cable.b).rod);
}

TEST_CASE("Orbits stay together") {
  const Model model = trefoil();
  const symmetry::Group group = group_of(model);
  auto problem = problem_of(model);
  problem.symmetry = group;
  const Network start = ground_structure::force_balance(problem, &group).network;
  const auto result = eliminate(start, problem, {.goal = {.max_error_percent = 1.0}});
  CHECK(result.stage.valid());
  const auto& found = result.stage.network.structure.cables;
  CHECK(found.size() < start.structure.cables.size());
  CHECK(symmetry::complete(found, group, 1e-3).size() == found.size());
}

TEST_CASE("A network that cannot be brought within the tolerance is told by its distance") {
  const Balance start = balance_of(trefoil(40));
  const auto result =
      eliminate(start.network, start.problem,
                {.goal = {.max_error_percent = 1e-7}, .local_search = {.max_rounds = 1}});
  CHECK(result.stage.valid());
  CHECK(sensitivity::deviation(start.problem.target, result.stage.network.state).max_percent >
        1e-7);
}

TEST_CASE("A number of cables that cannot be reached leaves the fewest there are") {
  const Balance start = balance_of(trefoil(40));
  const auto result =
      eliminate(start.network, start.problem, {.goal = {.max_error_percent = 0.01, .cables = 1}});
  CHECK(result.stage.valid());
  CHECK(cable_count(result.stage.network) < 10);
}
