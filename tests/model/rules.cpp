#include <catch2/catch.hpp>
#include <tencer/model/rules.hpp>

#include "fixtures/rods.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using model::Interval;
using model::place_allowed;
using model::RodPair;
using model::Rules;
using model::sliding_interval;

TEST_CASE("Ends slide to the ends of an open rod and once around a closed one") {
  const Model open = hung_helix(12);
  const Interval whole = sliding_interval({}, open.structure, 0, 0.3);
  CHECK(whole.lower == 0.0);
  CHECK(whole.upper == Approx(open.structure.rods[0].length()));
  const Model closed = trefoil(20);
  const double length = closed.structure.rods[0].length();
  const Interval around = sliding_interval({}, closed.structure, 0, 0.3 * length);
  CHECK(around.lower == Approx(-0.7 * length));
  CHECK(around.upper == Approx(1.3 * length));
}

TEST_CASE("Ends slide up to forbidden arcs, wherever on the turns they are") {
  const Model model = trefoil(20);
  const double length = model.structure.rods[0].length();
  const Rules rules{
      .forbidden = {{0, 0.9 * length, 0.1 * length}, {0, 0.5 * length, 0.6 * length}}};
  for (const double turns : {-3.0, 0.0, 2.0}) {
    const double offset = turns * length;
    const Interval interval = sliding_interval(rules, model.structure, 0, offset + 0.3 * length);
    CHECK(interval.lower == Approx(offset + 0.1 * length).margin(1e-6));
    CHECK(interval.upper == Approx(offset + 0.5 * length).margin(1e-6));
    CHECK(place_allowed(rules, model.structure, 0, interval.lower));
    CHECK(place_allowed(rules, model.structure, 0, interval.upper));
  }
}

TEST_CASE("Wrong rules are the caller's mistake") {
  const Model model = trefoil(20);
  const auto check = [&](const Rules& rules) {
    CHECK_THROWS_AS(validate(rules, model.structure), std::invalid_argument);
  };
  check({.pairs = std::vector<RodPair>{{0, 1}}});
  check({.forbidden = {{.rod = 2, .from = 0.0, .to = 0.1}}});
  check({.forbidden = {{.rod = 0, .from = 0.0, .to = 7.0}}});
  check({.max_cable_length = 0.0});
}
