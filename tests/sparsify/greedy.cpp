#include <catch2/catch.hpp>
#include <tencer/sparsify/greedy.hpp>

#include "fixtures/networks.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using namespace tencer::sparsify;
using network::Network;

namespace {

bool all_pull(const Network& network) { return cable_tensions(network).minCoeff() > 0; }

double residual(const Network& network) {
  return equilibrium::residual(equilibrium::System(network.structure), network.state);
}

}  // namespace

TEST_CASE("Pruning leaves an equilibrium in which every cable pulls") {
  for (const Model& model : {trefoil(), linked_ellipses(), hung_helix()}) {
    const Network dense = dense_network(model);
    const auto result = prune(dense, target_of(model, dense));
    CHECK(result.valid());
    CHECK(all_pull(result.network));
    CHECK(residual(result.network) < 1e-9);
    CHECK(cable_count(result.network) < cable_count(dense) / 2);
    CHECK(max_percent(model, result.network) < 1.0);
    REQUIRE(result.trace.size() == 1);
    CHECK(result.trace[0].cables == cable_count(result.network));
    CHECK(result.trace[0].max_percent == Approx(max_percent(model, result.network)));
    CHECK(result.trace[0].solves > 1);
  }
}

TEST_CASE("Pruned of what pushes hardest first, rods stay nearer to where they were") {
  const Model model = linked_ellipses();
  const Network dense = dense_network(model);
  const auto target = target_of(model, dense);
  const auto at_once = prune(dense, target);
  const auto hardest_first = prune(dense, target, {.hardest_part = 0.5});
  CHECK(hardest_first.valid());
  CHECK(all_pull(hardest_first.network));
  CHECK(hardest_first.trace[0].solves > at_once.trace[0].solves);
  CHECK(distance_per_vertex(target, hardest_first.network) <
        distance_per_vertex(target, at_once.network));
  CHECK_THROWS_AS(prune(dense, target, {.hardest_part = -0.1}), std::invalid_argument);
  CHECK_THROWS_AS(prune(dense, target, {.hardest_part = 1.1}), std::invalid_argument);
}

TEST_CASE("Pruning that is stopped balances what is left, or gives back what it was given") {
  const Model model = trefoil();
  const Network dense = dense_network(model);
  const auto target = target_of(model, dense);
  std::stop_source source;
  source.request_stop();
  const network::Control control{.stop = source.get_token()};
  const auto balanced = prune(dense, target, {}, control);
  CHECK(balanced.interrupted);
  CHECK(balanced.valid());
  const auto given = prune(dense, target, {.all_or_nothing = true}, control);
  CHECK(given.interrupted);
  CHECK_FALSE(given.valid());
  CHECK(cable_count(given.network) == cable_count(dense));
  CHECK(given.trace.back().note == "interrupted");
}

TEST_CASE("Greedy removal stays within its threshold and stops at it") {
  for (const Model& model : {trefoil(), linked_ellipses()}) {
    const Network dense = dense_network(model);
    const auto target = target_of(model, dense);
    const Network pruned = prune(dense, target).network;
    int last = cable_count(pruned);
    for (const double factor : {1.5, 3.0}) {
      const double threshold = factor * distance_per_vertex(target, pruned);
      const auto result = remove_greedily(pruned, target, {.threshold = threshold});
      CHECK(result.valid());
      CHECK(all_pull(result.network));
      CHECK(distance_per_vertex(target, result.network) <= threshold * (1 + 1e-4));
      CHECK(cable_count(result.network) < last);
      last = cable_count(result.network);
      // One more would be too many.
      Eigen::Index weakest = 0;
      cable_tensions(result.network).minCoeff(&weakest);
      Network fewer = result.network;
      fewer.structure.cables.erase(fewer.structure.cables.begin() + weakest);
      const auto beyond = prune(fewer, target);
      if (beyond.valid()) CHECK(distance_per_vertex(target, beyond.network) > threshold);
    }
  }
}

TEST_CASE("Greedy removal that is stopped at once returns what it was given") {
  const Model model = trefoil();
  const Network dense = dense_network(model);
  const auto target = target_of(model, dense);
  const Network pruned = prune(dense, target).network;
  std::stop_source source;
  source.request_stop();
  const auto result = remove_greedily(pruned, target, {}, {.stop = source.get_token()});
  CHECK(result.interrupted);
  CHECK(result.valid());
  CHECK(cable_count(result.network) == cable_count(pruned));
  CHECK(result.trace.back().note.find("interrupted") != std::string::npos);
}

TEST_CASE("Greedy removal that is stopped on the way returns the best so far") {
  const Model model = trefoil();
  const Network dense = dense_network(model);
  const auto target = target_of(model, dense);
  const Network pruned = prune(dense, target).network;
  std::stop_source source;
  const int enough = cable_count(pruned) - 5;
  const auto result =
      remove_greedily(pruned, target, {.threshold = 10 * distance_per_vertex(target, pruned)},
                      {.stop = source.get_token(), .progress = [&](const network::Progress& now) {
                         if (now.cables <= enough) source.request_stop();
                       }});
  CHECK(result.interrupted);
  CHECK(result.valid());
  CHECK(cable_count(result.network) <= enough);
  CHECK(cable_count(result.network) > enough - 5);
}

TEST_CASE("The initial network does not depend on units") {
  const Model model = trefoil();
  Model scaled = model;
  constexpr double length = 1e3;
  constexpr double force = 1e-4;
  auto& rod = scaled.structure.rods[0];
  rod.rest_lengths *= length;
  rod.section.EA *= force;
  for (double* stiffness : {&rod.section.EI1, &rod.section.EI2, &rod.section.GJ})
    *stiffness *= force * length * length;
  scaled.positions[0] *= length;
  const Network here = greedy_network(model);
  const Network there = greedy_network(scaled);
  REQUIRE(cable_count(here) == cable_count(there));
  CHECK(max_percent(model, here) == Approx(max_percent(scaled, there)).epsilon(1e-5));
}
