#include <catch2/catch.hpp>
#include <tencer/sparsify/balance.hpp>
#include <tencer/sparsify/thin.hpp>
#include <tencer/symmetry/orbit.hpp>

#include "models.hpp"

using namespace tencer;
using namespace tencer::sparsify;
using namespace tencer::sparsify::test;

namespace {

struct Start {
  Model model{};
  std::vector<springs::Cable> candidates{};
  sensitivity::Target target{};
  Network network{};
};

Start balanced(Model model, const Rules& rules = {}, const symmetry::Group* symmetry = nullptr) {
  Start start{.model = std::move(model)};
  const auto& structure = start.model.structure;
  start.candidates = candidates(structure, start.model.positions, rules).value();
  start.target = {.points = start.model.positions, .align = structure.anchors.cols() == 0};
  const Network bare{.structure = structure,
                     .state = equilibrium::make_state(structure, start.model.positions)};
  start.network = balance(bare, start.target, start.candidates, symmetry).network;
  return start;
}

}  // namespace

TEST_CASE("Thinning leaves few cables within the tolerance, all pulling, in stable equilibrium") {
  const Start start = balanced(trefoil());
  const auto result =
      thin(start.network, start.target, {}, start.candidates, nullptr, {.max_percent = 1.0});
  CHECK(result.stage.sound);
  const auto deviation = sensitivity::deviation(start.target, result.stage.network.state);
  CHECK(deviation.max_percent <= 1.0);
  CHECK(cables(result.stage.network) <= 10);
}

TEST_CASE("The number of cables asked for is not exceeded") {
  const Start start = balanced(trefoil());
  const auto result =
      thin(start.network, start.target, {}, start.candidates, nullptr, {.cables = 12});
  CHECK(result.stage.sound);
  CHECK(cables(result.stage.network) <= 12);
  CHECK(sensitivity::deviation(start.target, result.stage.network.state).max_percent < 0.5);
}

TEST_CASE("More cables are closer in the trade-off, and every network in it is sound") {
  const Start start = balanced(trefoil());
  const auto result = thin(start.network, start.target, {}, start.candidates, nullptr,
                           {.max_percent = 1.0, .every_number = true});
  REQUIRE(result.choices.size() > 4);
  for (std::size_t i = 0; i < result.choices.size(); ++i) {
    const Choice& choice = result.choices[i];
    CHECK(idle_cables(choice.network).empty());
    CHECK(choice.max_percent ==
          Approx(sensitivity::deviation(start.target, choice.network.state).max_percent));
    if (i == 0) continue;
    CHECK(cables(choice.network) > cables(result.choices[i - 1].network));
    CHECK(choice.max_percent < result.choices[i - 1].max_percent);
  }
}

TEST_CASE("The result does not depend on the number of threads") {
  const Start start = balanced(trefoil(40));
  std::vector<Network> results;
  for (const int threads : {1, 2})
    results.push_back(thin(start.network, start.target, {}, start.candidates, nullptr,
                           {.max_percent = 2.0, .threads = threads})
                          .stage.network);
  REQUIRE(cables(results[0]) == cables(results[1]));
  for (std::size_t r = 0; r < results[0].state.size(); ++r)
    CHECK(results[0].state[r].x == results[1].state[r].x);
}

TEST_CASE("Thinning keeps to the rules") {
  const Model model = linked_ellipses();
  Rules rules{.pairs = std::vector<RodPair>{{0, 1}}};
  rules.longest = 0.6;
  const Start start = balanced(model, rules);
  const auto result =
      thin(start.network, start.target, rules, start.candidates, nullptr, {.max_percent = 2.0});
  CHECK(result.stage.sound);
  CHECK(cables(result.stage.network) < cables(start.network));
  CHECK(cable_lengths(result.stage.network).maxCoeff() <= 0.6 * (1 + 1e-9));
  for (const auto& cable : result.stage.network.structure.cables)
    CHECK(std::get<springs::OnRod>(cable.a).rod != std::get<springs::OnRod>(cable.b).rod);
}

TEST_CASE("Orbits stay together") {
  const Model model = trefoil();
  const symmetry::Group group = group_of(model);
  const Start start = balanced(model, {}, &group);
  const auto result =
      thin(start.network, start.target, {}, start.candidates, &group, {.max_percent = 1.0});
  CHECK(result.stage.sound);
  const auto& found = result.stage.network.structure.cables;
  CHECK(found.size() < start.network.structure.cables.size());
  CHECK(symmetry::complete(found, group, 1e-3).size() == found.size());
}

TEST_CASE("A network that cannot be brought within the tolerance is told by its distance") {
  const Start start = balanced(trefoil(40));
  const auto result =
      thin(start.network, start.target, {}, start.candidates, nullptr, {.max_percent = 1e-7});
  CHECK(result.stage.sound);
  CHECK(sensitivity::deviation(start.target, result.stage.network.state).max_percent > 1e-7);
}

TEST_CASE("A number of cables that cannot be reached leaves the fewest there are") {
  const Start start = balanced(trefoil(40));
  const auto result = thin(start.network, start.target, {}, start.candidates, nullptr,
                           {.max_percent = 0.01, .cables = 1});
  CHECK(result.stage.sound);
  CHECK(cables(result.stage.network) < 10);
}
