#include <catch2/catch.hpp>
#include <tencer/fabricate/purchase.hpp>

#include "designs.hpp"

using namespace tencer;
using namespace tencer::fabricate;

namespace {

CutList list_with(const Allowances& allowances) {
  return cut_list(fixtures::ring_and_bar("cm", "N"), allowances);
}

}  // namespace

TEST_CASE("Without stock and price what is needed is bought, and costs nobody knows what") {
  const auto bought = buy_rods(list_with({.joint = 30}), {});
  REQUIRE(bought);
  CHECK(bought->needed == Approx(1130));
  CHECK(bought->bought == Approx(1130));
  CHECK_FALSE(bought->packing);
  CHECK_FALSE(bought->cost);
}

TEST_CASE("Whole bars are bought") {
  const auto bought = buy_rods(list_with({.joint = 30}), {.stock = 1000, .price_per_metre = 2.0});
  REQUIRE(bought);
  CHECK(bought->packing->bars.size() == 2);
  CHECK(bought->bought == Approx(2000));
  CHECK(*bought->cost == Approx(4));
}

TEST_CASE("A rod longer than a bar is spliced, each splice taking a joint") {
  const auto bought = buy_rods(list_with({.joint = 30}), {.stock = 500});
  REQUIRE(bought);
  REQUIRE(bought->pieces.size() == 3);
  CHECK(bought->pieces[0].length == Approx(500));
  CHECK(bought->pieces[1].of == 0);
  CHECK(bought->pieces[1].length == Approx(830 - 500 + 30));
  CHECK(bought->needed == Approx(1160));
  const auto overlaps = splices(list_with({.joint = 30}), *bought);
  REQUIRE(overlaps.size() == 1);
  CHECK(overlaps[0].rod == 0);
  CHECK(overlaps[0].from == Approx(470));
  CHECK(overlaps[0].to == Approx(500));
  CHECK(*overlaps[0].nearest_mark == Approx(40));  // the one 430 from the end
  const auto short_bars = buy_rods(list_with({.joint = 30}), {.stock = 30});
  REQUIRE_FALSE(short_bars);
  CHECK(short_bars.error().text() ==
        "bars of 30.0 mm are no longer than the 30.0 mm that a joint takes");
}

TEST_CASE("Cables are cut from coils, and none is spliced") {
  const auto bought = buy_cables(list_with({.knot = 50}), {.stock = 400, .price_per_metre = 0.5});
  REQUIRE(bought);
  CHECK(bought->needed == Approx(346 + 216 + 188));
  CHECK(bought->packing->bars.size() == 3);
  CHECK(*bought->cost == Approx(0.6));
  const auto short_coils = buy_cables(list_with({.knot = 50}), {.stock = 300});
  REQUIRE_FALSE(short_coils);
  CHECK(short_coils.error().text() == "cable 1 is cut to 346.0 mm, longer than a coil of 300.0 mm");
}
