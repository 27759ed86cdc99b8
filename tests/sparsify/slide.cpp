#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/sparsify/slide.hpp>

#include "backends.hpp"
#include "fixtures/networks.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using model::SecondDerivatives;
using network::Network;
using sparsify::slide;

namespace {

double distance(const Model& model, const Network& network) {
  return sensitivity::deviation(target_of(model, network), network.state).value;
}

void check_places(const Model& model, const Network& network, const model::Rules& rules) {
  for (const auto& cable : network.structure.cables)
    for (const auto& end : {cable.a, cable.b})
      if (const auto* on = std::get_if<springs::OnRod>(&end)) {
        CHECK(place_allowed(rules, model.structure, on->rod, on->s));
        if (!model.structure.rods[on->rod].closed) {
          CHECK(on->s >= 0.0);
          CHECK(on->s <= model.structure.rods[on->rod].length());
        }
      }
}

}  // namespace

TEST_CASE("Sliding brings the shape much nearer to the target, comparably with every optimizer") {
  const Model model = trefoil();
  const Network start = greedy_network(model, 10.0);
  const auto target = target_of(model, start);
  std::vector<double> reached;
  for (const auto& backend : backends()) {
    CAPTURE(backend.name);
    const auto result = slide(start, target, {}, backend);
    CHECK(result.valid());
    CHECK(cable_count(result.network) <= cable_count(start));
    CHECK(cable_tensions(result.network).minCoeff() > 0);
    reached.push_back(std::sqrt(distance(model, result.network)));
    CHECK(reached.back() < 0.5 * std::sqrt(distance(model, start)));
  }
  // Each ends where it can gain no more, not necessarily in the same of many such places.
  if (!reached.empty())
    CHECK(*std::ranges::max_element(reached) < 4 * *std::ranges::min_element(reached));
}

TEST_CASE("Attachments move away from the vertices where they start") {
  const Model model = trefoil();
  const Network start = greedy_network(model, 20.0);
  const auto target = target_of(model, start);
  for (const auto& backend : backends()) {
    CAPTURE(backend.name);
    const auto result = slide(start, target, {}, backend);
    REQUIRE(cable_count(result.network) == cable_count(start));
    double furthest = 0;
    for (int i = 0; i < cable_count(start); ++i) {
      const auto& from = start.structure.cables[i];
      const auto& to = result.network.structure.cables[i];
      for (const auto& [a, b] : {std::pair(from.a, to.a), std::pair(from.b, to.b)})
        furthest = std::max(
            furthest, std::abs(std::get<springs::OnRod>(b).s - std::get<springs::OnRod>(a).s));
    }
    const double edge = model.structure.rods[0].rest_lengths[0];
    CHECK(furthest > 0.1 * edge);
    // Methods that get far pass vertices, where the derivative jumps.
    if (backend.uses_hessian) CHECK(furthest > edge);
  }
}

TEST_CASE("Sliding respects forbidden arcs, the ends of rods and the longest cable") {
  const Model closed = trefoil();
  const Model open = hung_helix();
  const double length = closed.structure.rods[0].length();
  const double longest = 0.8 * cable_lengths(dense_network(closed)).maxCoeff();
  const model::Rules rules{
      .forbidden = {{0, 0.3 * length, 0.4 * length}, {0, 0.95 * length, 0.02 * length}},
      .max_cable_length = longest};
  for (const auto& backend : backends()) {
    CAPTURE(backend.name);
    const Network start = greedy_network(closed, 10.0, rules);
    REQUIRE(cable_lengths(start).maxCoeff() <= longest);
    const auto target = target_of(closed, start);
    const auto result = slide(start, target, rules, backend, quick());
    CHECK(result.valid());
    CHECK(distance(closed, result.network) < distance(closed, start));
    CHECK(cable_lengths(result.network).maxCoeff() <= longest * (1 + 1e-8));
    check_places(closed, result.network, rules);

    const Network hung = greedy_network(open, 10.0);
    const auto slid = slide(hung, target_of(open, hung), {}, backend, quick());
    CHECK(slid.valid());
    CHECK(distance(open, slid.network) < distance(open, hung));
    check_places(open, slid.network, {});
  }
}

TEST_CASE("Second derivatives, approximate or exact or none, lead to comparable designs") {
  const Model model = trefoil();
  const Network start = greedy_network(model, 10.0);
  const auto target = target_of(model, start);
  for (const auto& backend : backends()) {
    if (!backend.uses_hessian) continue;
    for (const auto second : {SecondDerivatives::limited_memory, SecondDerivatives::gauss_newton,
                              SecondDerivatives::exact}) {
      sparsify::OuterOptions outer = quick();
      outer.second_derivatives = second;
      const auto result = slide(start, target, {}, backend, outer);
      CHECK(result.valid());
      CHECK(distance(model, result.network) < 0.25 * distance(model, start));
    }
  }
}
