#include <catch2/catch.hpp>
#include <tencer/ground_structure/candidates.hpp>

#include "fixtures/problems.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using Catch::Matchers::Contains;
using ground_structure::candidates;
using model::RodPair;
using model::Rules;

namespace {

const springs::OnRod& on_rod(const springs::End& end) { return std::get<springs::OnRod>(end); }

}  // namespace

TEST_CASE("Candidates join all pairs of vertices that are not neighbours") {
  const Model closed = trefoil(20);
  CHECK(candidates(closed.structure, closed.positions, {})->size() == 20 * 19 / 2 - 20);
  Model open = hung_helix(12);
  open.structure.anchors.resize(3, 0);
  CHECK(candidates(open.structure, open.positions, {})->size() == 12 * 11 / 2 - 11);
  const Model two = linked_ellipses(10);
  CHECK(candidates(two.structure, two.positions, {})->size() == 20 * 19 / 2 - 20);
}

TEST_CASE("Anchors add a candidate for each vertex, when external cables are allowed") {
  const Model model = hung_helix(12);
  CHECK(candidates(model.structure, model.positions, {})->size() == 55 + 12 * 8);
  CHECK(candidates(model.structure, model.positions, {.external = false})->size() == 55);
}

TEST_CASE("Candidates keep to the allowed pairs of rods") {
  const Model model = linked_ellipses(10);
  const Rules rules{.pairs = std::vector<RodPair>{{1, 0}}};
  const auto between = candidates(model.structure, model.positions, rules).value();
  CHECK(between.size() == 100);
  for (const auto& cable : between) CHECK(on_rod(cable.a).rod != on_rod(cable.b).rod);
}

TEST_CASE("Candidates keep clear of forbidden arcs, also across the seam") {
  const Model model = trefoil(20);
  const double length = model.structure.rods[0].length();
  const Rules rules{.forbidden = {{.rod = 0, .from = 0.88 * length, .to = 0.12 * length}}};
  const auto found = candidates(model.structure, model.positions, rules).value();
  // Vertices 18, 19, 0, 1 and 2 are lost.
  CHECK(found.size() == 15 * 14 / 2 - 14);
  for (const auto& cable : found)
    for (const auto& end : {cable.a, cable.b}) {
      CHECK(on_rod(end).s < 0.88 * length);
      CHECK(on_rod(end).s > 0.12 * length);
    }
}

TEST_CASE("Candidates are shorter than the longest cable") {
  const Model model = trefoil(20);
  const network::Network all = dense_network(model);
  const double longest = 0.5 * cable_lengths(all).maxCoeff();
  const network::Network network = dense_network(model, {.max_cable_length = longest});
  CHECK(cable_count(network) > 0);
  CHECK(cable_count(network) < cable_count(all));
  CHECK(cable_lengths(network).maxCoeff() <= longest);
}

TEST_CASE("Rules that leave no cable are an error that says which") {
  const Model model = linked_ellipses(10);
  const auto error = [&](const Rules& rules) {
    const auto found = candidates(model.structure, model.positions, rules);
    REQUIRE_FALSE(found);
    return found.error().text();
  };
  CHECK_THAT(error({.pairs = std::vector<RodPair>{}}),
             Contains("no cables are allowed") && Contains("pairs"));
  CHECK_THAT(error({.max_cable_length = 1e-3}),
             Contains("no cables are allowed") && Contains("longest"));
  const double length = model.structure.rods[0].length();
  CHECK_THAT(error({.forbidden = {{0, 0.0, length}, {1, 0.0, length}}}),
             Contains("no cables are allowed") && Contains("forbidden"));
}

TEST_CASE("A rod that meets itself in a vertex is an error that names rod and vertices") {
  Model model = trefoil(20);
  model.positions[0].col(13) = model.positions[0].col(4);
  const auto found = candidates(model.structure, model.positions, {});
  REQUIRE_FALSE(found);
  CHECK_THAT(found.error().text(), Contains("rods[0]") && Contains("vertex 4") && Contains("13"));
}

TEST_CASE("A vertex at an anchor is an error unless no cable may go there") {
  Model model = hung_helix(12);
  model.structure.anchors.col(3) = model.positions[0].col(5);
  const auto found = candidates(model.structure, model.positions, {});
  REQUIRE_FALSE(found);
  CHECK_THAT(found.error().text(), Contains("vertex 5") && Contains("anchors[3]"));
  CHECK(candidates(model.structure, model.positions, {.external = false}));
}

TEST_CASE("Cables between held vertices are left out") {
  Model model = hung_helix(12);
  model.structure.anchors.resize(3, 0);
  model.structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 11}};
  CHECK(candidates(model.structure, model.positions, {})->size() == 55 - 1);
}

TEST_CASE("Candidates of a rod do not grow with the square of its vertices") {
  const auto count = [](int vertices) { return problem_of(trefoil(vertices)).candidates.size(); };
  CHECK(count(400) == 400 * 397 / 2);
  CHECK(count(4000) == count(400));
  CHECK(count(4100) < count(400));
  // Nor of many rods.
  CHECK(problem_of(chain(6, 500)).candidates.size() <= 1500 * 1500 / 2);
}
