#include <catch2/catch.hpp>
#include <limits>
#include <numbers>
#include <random>
#include <tencer/fabricate/cut_list.hpp>
#include <tencer/fabricate/names.hpp>

#include "designs.hpp"

using namespace tencer;
using namespace tencer::fabricate;

TEST_CASE("Rods are cut to their length and the joint, and marked from their start") {
  const CutList list = cut_list(fixtures::ring_and_bar("cm", "N"), {.joint = 30});
  REQUIRE(list.rods.size() == 2);
  const RodCut& ring = list.rods[0];
  CHECK(ring.closed);
  CHECK(ring.length == Approx(800));
  CHECK(ring.cut == Approx(830));
  CHECK(ring.radius == Approx(2));
  REQUIRE(ring.marks.size() == 3);
  // The last mark is 20 from the start: the joint is in the middle between the others.
  CHECK(ring.joint == Approx(350));
  CHECK(*ring.nearest_mark == Approx(200));
  CHECK(ring.marks[0].s == Approx(550));
  CHECK(ring.marks[1].s == Approx(780));
  CHECK(ring.from_end(ring.marks[1].s) == Approx(430));
  CHECK(ring.marks[2].s == Approx(150));
  CHECK(ring.from_end(ring.marks[2].s) == Approx(600));
  CHECK(ring.marks[2].cable == 0);
  CHECK(ring.marks[2].end == 1);
  const RodCut& bar = list.rods[1];
  CHECK(bar.cut == Approx(300));  // an open rod has no joint
  CHECK_FALSE(bar.nearest_mark);
  CHECK(bar.joint == 0);
  CHECK(bar.marks.back().s == Approx(300));
  CHECK(list.rods_cut() == Approx(1130));
  const double kg_per_mm = std::numbers::pi * 4e-9 * *model::glass_fibre().density;
  CHECK(*list.rods_mass() == Approx(1130 * kg_per_mm));
}

TEST_CASE("Cables lose the rods' radii and gain their knots") {
  const CutList list = cut_list(fixtures::ring_and_bar("cm", "N"), {.knot = 50});
  REQUIRE(list.cables.size() == 3);
  CHECK(list.cables[0].between_centres == Approx(250));
  CHECK(list.cables[0].between_knots == Approx(246));
  CHECK(list.cables[0].cut == Approx(346));
  CHECK(list.cables[0].tension == Approx(4));
  CHECK(list.cables[2].between_knots == Approx(88));  // an anchor is a point
  CHECK(list.cables[2].cut == Approx(188));
  CHECK(list.cables_cut() == Approx(346 + 216 + 188));
}

TEST_CASE("The unit that a design is in makes no difference") {
  const CutList expected = cut_list(fixtures::ring_and_bar("mm", "N"));
  for (const char* length : {"cm", "m"})
    for (const char* force : {"mN", "kN"}) {
      const CutList list = cut_list(fixtures::ring_and_bar(length, force));
      for (std::size_t r = 0; r < list.rods.size(); ++r) {
        CHECK(list.rods[r].cut == Approx(expected.rods[r].cut));
        CHECK(*list.rods[r].mass == Approx(*expected.rods[r].mass));
        for (std::size_t m = 0; m < list.rods[r].marks.size(); ++m)
          CHECK(list.rods[r].marks[m].s == Approx(expected.rods[r].marks[m].s));
      }
      for (std::size_t c = 0; c < list.cables.size(); ++c) {
        CHECK(list.cables[c].cut == Approx(expected.cables[c].cut));
        CHECK(list.cables[c].tension == Approx(expected.cables[c].tension));
      }
    }
}

TEST_CASE("Every end on a rod is one of its marks, at the place that the cable says") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-900, 900);
  model::Design design = fixtures::ring_and_bar("mm", "N");
  for (int i = 0; i < 40; ++i) {
    design.structure.cables.push_back(
        {.a = springs::OnRod{0, place(random)}, .b = springs::OnRod{i % 2, place(random)}});
    design.built.push_back({.length = 100, .tension = 1});
  }
  const CutList list = cut_list(design);
  std::size_t marks = 0;
  for (std::size_t r = 0; r < list.rods.size(); ++r)
    for (std::size_t m = 0; m < list.rods[r].marks.size(); ++m, ++marks) {
      const model::Mark& mark = list.rods[r].marks[m];
      const CableCut& cable = list.cables[mark.cable];
      const auto& on = std::get<springs::OnRod>(mark.end == 0 ? cable.a : cable.b);
      CHECK(on.rod == static_cast<int>(r));
      CHECK(on.s == Approx(mark.s));
      CHECK(mark.s >= 0);
      CHECK(mark.s <= list.rods[r].length);
      if (m > 0)
        CHECK(list.rods[r].from_end(mark.s) >= list.rods[r].from_end(list.rods[r].marks[m - 1].s));
    }
  CHECK(marks == 2 * list.cables.size() - 1);  // one is at the anchor
}

TEST_CASE("Rods without a material weigh nobody knows what") {
  model::Design design = fixtures::ring_and_bar("mm", "N");
  design.structure.materials.clear();
  CHECK_FALSE(cut_list(design).rods_mass());
}

TEST_CASE("Allowances that are no lengths are refused") {
  const auto design = fixtures::ring_and_bar("mm", "N");
  CHECK_THROWS_AS(cut_list(design, {.joint = -1}), std::invalid_argument);
  CHECK_THROWS_AS(cut_list(design, {.knot = std::numeric_limits<double>::quiet_NaN()}),
                  std::invalid_argument);
}

TEST_CASE("Lengths at the bench have one decimal, ends the names of their rods") {
  CHECK(tenths(103.44) == "103.4");
  CHECK(tenths(-0.01) == "0.0");
  CHECK(end_name(springs::OnRod{1, 20}) == "B 20.0");
  CHECK(end_name(springs::AtAnchor{2}) == "anchor 3");
}
