#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/curves/analytic.hpp>
#include <tencer/lower_bound/at_least.hpp>
#include <tencer/random_targets/random_knot.hpp>

#include "fixtures/rods.hpp"

using namespace tencer;
using lower_bound::at_least;

namespace {

int ends_of(const fixtures::Model& model, double percent) {
  return at_least(model.structure, model::make_target(model.structure, model.positions), percent)
      .ends;
}

}  // namespace

TEST_CASE("a circle needs no cable, and neither does a straight rod", "[lower_bound]") {
  CHECK(ends_of(fixtures::make_model({curves::circle(25, 60)}), 0.01) == 0);
  geometry::Polyline line{.points = Eigen::Matrix3Xd::Zero(3, 30), .closed = false};
  line.points.row(0).setLinSpaced(0, 10);
  CHECK(ends_of(fixtures::make_model({line}), 0.01) == 0);
}

TEST_CASE("a trefoil needs cables, more of them within a smaller error", "[lower_bound]") {
  const fixtures::Model trefoil = fixtures::trefoil(80);
  CHECK(ends_of(trefoil, 0.25) >= 2);
  CHECK(ends_of(trefoil, 0.05) > ends_of(trefoil, 0.25));
  CHECK(ends_of(trefoil, 100) == 0);
}

TEST_CASE("no rod at rest under springs has fewer than are needed", "[lower_bound]") {
  for (const int cables : {2, 3, 6}) {
    const auto knot = random_targets::random_knot(
        {.cables = cables, .vertices = 80, .seed = 2, .clearance = 0.001});
    REQUIRE(knot);
    const fixtures::Model model = fixtures::make_model({knot->curve});
    for (const double percent : {0.02, 0.5}) {
      INFO(cables << " springs, " << percent << " %");
      CHECK(ends_of(model, percent) <= 2 * cables);
    }
  }
}

TEST_CASE("pins, loads and weight may do what cables do", "[lower_bound]") {
  fixtures::Model model = fixtures::trefoil(80);
  const auto target = model::make_target(model.structure, model.positions);
  const int free = at_least(model.structure, target, 0.1).ends;
  REQUIRE(free > 0);
  fixtures::Model pinned = model;
  for (int v = 0; v < 80; v += 5) pinned.structure.pins.push_back({.vertex = v});
  CHECK(at_least(pinned.structure, target, 0.1).ends == 0);
  fixtures::Model loaded = model;
  loaded.structure.point_loads.push_back({.s = 0.5, .force = {0, 0, 1}});
  CHECK(at_least(loaded.structure, target, 0.1).ends <= free);
  fixtures::Model heavy = model;
  heavy.structure.line_loads.push_back({.force_per_length = {0, 0, -1}});
  CHECK(at_least(heavy.structure, target, 0.1).ends == 0);
}

TEST_CASE("nothing is claimed of rods that are not straight, round and free to twist",
          "[lower_bound]") {
  for (const int kind : {0, 1}) {
    fixtures::Model model = fixtures::trefoil(80);
    der::Rod& rod = model.structure.rods[0];
    if (kind == 0) rod.section.EI2 = 2;
    if (kind == 1) rod.closing_angle = 0.0;
    CHECK(ends_of(model, 0.1) == 0);
  }
}

TEST_CASE("of what is seen from a side nothing is proven") {
  const fixtures::Model model = fixtures::trefoil(48);
  auto target = model::make_target(model.structure, model.positions);
  target.views = {{}};
  CHECK_THROWS_AS(at_least(model.structure, target, 1), std::invalid_argument);
}

TEST_CASE("stretches are places where a cable has to end", "[lower_bound]") {
  const fixtures::Model trefoil = fixtures::trefoil(80);
  const auto found =
      at_least(trefoil.structure, model::make_target(trefoil.structure, trefoil.positions), 0.1);
  REQUIRE_FALSE(found.stretches.empty());
  CHECK(found.cables == (found.ends + 1) / 2);
  for (const model::Arc& stretch : found.stretches) {
    CHECK(stretch.from < stretch.to);
    CHECK(stretch.to - stretch.from <= 1 + 1e-9);
  }
}
