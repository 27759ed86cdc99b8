#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "models.hpp"

using namespace tencer;
using namespace tencer::sparsify;
using namespace tencer::sparsify::test;

namespace {

bool all_pull(const Network& network) { return cable_tensions(network).minCoeff() > 0; }

double residual(const Network& network) {
  return equilibrium::residual(equilibrium::System(network.structure), network.state);
}

}  // namespace

TEST_CASE("Dense springs hold the target, at the paper's stiffness") {
  const Model model = trefoil();
  const Network network = dense_network(model);
  // 100 E c^2 / L with E = EA^2 / (4 pi EI) and c the diameter, c^2 = 16 EI / EA.
  const auto& rod = model.structure.rods[0];
  const double modulus = rod.section.EA * rod.section.EA / (4 * std::numbers::pi * rod.section.EI1);
  const double stiffness = 100 * modulus * 16 * rod.section.EI1 / rod.section.EA / rod.length();
  for (const auto& cable : network.structure.cables)
    CHECK(cable.stiffness == Approx(stiffness).epsilon(1e-12));
  CHECK(cable_tensions(network).cwiseAbs().maxCoeff() == 0.0);
}

TEST_CASE("Pruning leaves an equilibrium in which every cable pulls") {
  for (const Model& model : {trefoil(), linked_ellipses(), hung_helix()}) {
    const Network dense = dense_network(model);
    const auto result = prune(dense, target_of(model, dense));
    CHECK(result.sound);
    CHECK(all_pull(result.network));
    CHECK(residual(result.network) < 1e-9);
    CHECK(cables(result.network) < cables(dense) / 2);
    CHECK(max_percent(model, result.network) < 1.0);
    REQUIRE(result.trace.size() == 1);
    CHECK(result.trace[0].cables == cables(result.network));
    CHECK(result.trace[0].max_percent == Approx(max_percent(model, result.network)));
    CHECK(result.trace[0].solves > 1);
  }
}

TEST_CASE("Decimation stays within its threshold and stops at it") {
  for (const Model& model : {trefoil(), linked_ellipses()}) {
    const Network dense = dense_network(model);
    const auto target = target_of(model, dense);
    const Network pruned = prune(dense, target).network;
    int last = cables(pruned);
    for (const double factor : {1.5, 3.0}) {
      const double threshold = factor * distance_per_vertex(target, pruned);
      const auto result = decimate(pruned, target, {.threshold = threshold});
      CHECK(result.sound);
      CHECK(all_pull(result.network));
      CHECK(distance_per_vertex(target, result.network) <= threshold * (1 + 1e-4));
      CHECK(cables(result.network) < last);
      last = cables(result.network);
      // One more would be too many.
      Eigen::Index weakest = 0;
      cable_tensions(result.network).minCoeff(&weakest);
      Network fewer = result.network;
      fewer.structure.cables.erase(fewer.structure.cables.begin() + weakest);
      const auto beyond = prune(fewer, target);
      if (beyond.sound) CHECK(distance_per_vertex(target, beyond.network) > threshold);
    }
  }
}

TEST_CASE("Decimation that is stopped at once returns what it was given") {
  const Model model = trefoil();
  const Network dense = dense_network(model);
  const auto target = target_of(model, dense);
  const Network pruned = prune(dense, target).network;
  std::stop_source source;
  source.request_stop();
  const auto result = decimate(pruned, target, {}, {.stop = source.get_token()});
  CHECK(result.interrupted);
  CHECK(result.sound);
  CHECK(cables(result.network) == cables(pruned));
  CHECK(result.trace.back().note.find("interrupted") != std::string::npos);
}

TEST_CASE("Decimation that is stopped on the way returns the best so far") {
  const Model model = trefoil();
  const Network dense = dense_network(model);
  const auto target = target_of(model, dense);
  const Network pruned = prune(dense, target).network;
  std::stop_source source;
  const int enough = cables(pruned) - 5;
  const auto result =
      decimate(pruned, target, {.threshold = 10 * distance_per_vertex(target, pruned)},
               {.stop = source.get_token(), .progress = [&](const Progress& now) {
                  if (now.cables <= enough) source.request_stop();
                }});
  CHECK(result.interrupted);
  CHECK(result.sound);
  CHECK(cables(result.network) <= enough);
  CHECK(cables(result.network) > enough - 5);
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
  const Network here = decimated(model);
  const Network there = decimated(scaled);
  REQUIRE(cables(here) == cables(there));
  CHECK(max_percent(model, here) == Approx(max_percent(scaled, there)).epsilon(1e-5));
}
