#include "multistart/starts.hpp"

#include <catch2/catch.hpp>

#include "fixtures/problems.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using elimination::EliminationOptions;
using elimination::Start;
using elimination::Starts;
using elimination::starts_of;
using ground_structure::Problem;

namespace {

double percent_of(const Problem& problem, const Start& start) {
  return sensitivity::deviation(problem.target, start.network.state).max_percent;
}

}  // namespace

TEST_CASE("A search begins with balances, and with few orbits of the target's symmetries") {
  const Problem problem = problem_of(trefoil());
  network::StageResult result{.network = problem.bare()};
  const Starts starts = starts_of(problem, {}, {}, result);
  CHECK(result.trace.size() == 1);
  CHECK(result.trace[0].stage == "balance");
  REQUIRE_FALSE(starts.full.empty());
  REQUIRE_FALSE(starts.few.empty());
  CHECK_FALSE(starts.many_rods);
  for (const Start& start : starts.full) CHECK(percent_of(problem, start) < 1.0);
  for (const Start& start : starts.few) CHECK(start.symmetry != nullptr);
}

TEST_CASE("Where no balance holds the rods near the target, springs do") {
  const Problem problem = problem_of(linked_ellipses());
  EliminationOptions options;
  options.start.mendable = 1.0;
  options.start.balances = {{{6.0, 1}, {6.0, 1}}};  // too rough
  network::StageResult result{.network = problem.bare()};
  const Starts starts = starts_of(problem, options, {}, result);
  REQUIRE(result.trace.size() == 3);
  CHECK(result.trace[1].stage == "prune");
  CHECK(result.trace[2].stage == "greedy");
  REQUIRE(starts.full.size() == 1);
  CHECK(network::fault_of(starts.full.front().network) == network::Fault::none);
  CHECK(percent_of(problem, starts.full.front()) < 1.0);
}

TEST_CASE("Springs keep no symmetry: a search that keeps one begins without") {
  const Model model = trefoil();
  Problem problem = problem_of(model);
  problem.symmetry = group_of(model);
  EliminationOptions options;
  options.start.mendable = 1e-9;
  network::StageResult result{.network = problem.bare()};
  const Starts starts = starts_of(problem, options, {}, result);
  CHECK(result.trace.size() == 1);
  REQUIRE_FALSE(starts.full.empty());
  for (const Start& start : starts.full) CHECK(start.symmetry == problem.group());
}
