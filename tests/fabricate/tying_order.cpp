#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <tencer/fabricate/tying_order.hpp>

#include "designs.hpp"

using namespace tencer;

TEST_CASE("Cables are tied from the first mark on, next to those that are tied") {
  // The first mark of rod A is at 150, cable 1's. At 780 and 550 are cables 2 and 1 next to each
  // other; cable 3 hangs on the open rod, which cable 2 is tied to.
  const auto order = fabricate::tying_order(fabricate::cut_list(fixtures::ring_and_bar("cm", "N")));
  CHECK(order == std::vector<int>{0, 1, 2});
}

TEST_CASE("The nearest way along a closed rod may lead across its joint") {
  model::Design design = fixtures::ring_and_bar("mm", "N");
  design.structure.cables = {{.a = springs::OnRod{0, 300}, .b = springs::AtAnchor{0}},
                             {.a = springs::OnRod{0, 790}, .b = springs::AtAnchor{0}},
                             {.a = springs::OnRod{0, 10}, .b = springs::AtAnchor{0}}};
  CHECK(fabricate::tying_order(fabricate::cut_list(design)) == std::vector<int>{2, 1, 0});
}

TEST_CASE("Every cable is tied once, and next to another as long as there is one") {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> place(0, 300);
  model::Design design = fixtures::ring_and_bar("mm", "N");
  for (int i = 0; i < 60; ++i) {
    design.structure.cables.push_back({.a = springs::OnRod{i % 2, place(random)},
                                       .b = springs::OnRod{(i / 2) % 2, place(random)}});
    design.built.push_back({.length = 100, .tension = 1});
  }
  const auto list = fabricate::cut_list(design);
  auto order = fabricate::tying_order(list);
  std::vector<bool> reached(2, false);
  int beginnings = 0;
  for (const int c : order) {
    bool joins = false;
    for (const auto& end : {list.cables[c].a, list.cables[c].b})
      if (const auto* on = std::get_if<springs::OnRod>(&end)) joins |= reached[on->rod];
    for (const auto& end : {list.cables[c].a, list.cables[c].b})
      if (const auto* on = std::get_if<springs::OnRod>(&end)) reached[on->rod] = true;
    if (!joins) ++beginnings;
  }
  CHECK(beginnings == 1);
  std::ranges::sort(order);
  for (std::size_t i = 0; i < order.size(); ++i) CHECK(order[i] == static_cast<int>(i));
  CHECK(order.size() == list.cables.size());
}
