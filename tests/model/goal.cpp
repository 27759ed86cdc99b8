// What answers a request: tests/elimination/pareto_archive.cpp has the same for archives.
#include <catch2/catch.hpp>
#include <tencer/model/goal.hpp>
#include <vector>

using tencer::model::Footing;
using tencer::model::Goal;
using tencer::model::Score;

TEST_CASE("a goal of an error is met by what is close enough, a goal of a number by few enough") {
  const Goal within{.max_error_percent = 1.0};
  CHECK(within.met({.cables = 50, .max_percent = 1.0}));
  CHECK_FALSE(within.met({.cables = 3, .max_percent = 1.01}));
  const Goal eight{.max_error_percent = 1.0, .cables = 8};
  CHECK(eight.met({.cables = 8, .max_percent = 30.0}));
  CHECK_FALSE(eight.met({.cables = 9, .max_percent = 0.1}));
}

TEST_CASE("within an error the fewest cables are picked, and failing that the closest") {
  const Goal within{.max_error_percent = 1.0};
  const std::vector<Score> scores{{5, 3.0}, {7, 0.9}, {9, 0.5}};
  CHECK(within.pick(scores) == 1);
  CHECK(within.pick(std::vector<Score>{{5, 3.0}, {7, 1.5}, {9, 2.0}}) == 1);
  CHECK(within.pick({}) == -1);
}

TEST_CASE("with a number of cables the closest of those that have few enough is picked") {
  const Goal eight{.cables = 8};
  CHECK(eight.pick(std::vector<Score>{{5, 3.0}, {7, 4.0}, {8, 2.0}, {9, 0.5}}) == 2);
  // None has few enough: the one with the fewest comes nearest.
  CHECK(eight.pick(std::vector<Score>{{9, 3.0}, {12, 0.1}}) == 0);
}

TEST_CASE("what stands is preferred, with a number of cables up to twice the distance") {
  const Score near{8, 1.0, Footing::none};
  const Goal eight{.cables = 8};
  CHECK(eight.prefers_footing({8, 2.0, Footing::stands}, near));
  CHECK_FALSE(eight.prefers_footing({8, 2.1, Footing::stands}, near));
  const Goal within{.max_error_percent = 1.0};
  CHECK(within.prefers_footing({20, 0.9, Footing::stands}, near));
  CHECK_FALSE(within.prefers_footing({20, 1.1, Footing::stands}, near));
}

TEST_CASE(
    "an answer improves on another by its footing, then by fewer cables, then by 3 % at least") {
  const Goal within{.max_error_percent = 1.0};
  CHECK(within.improves({9, 0.9, Footing::stands}, {7, 0.5, Footing::none}));
  CHECK_FALSE(within.improves({7, 0.5, Footing::none}, {9, 0.9, Footing::stands}));
  CHECK_FALSE(within.improves({9, 1.5, Footing::stands},
                              {7, 0.5, Footing::none}));  // stands, but is too far away
  CHECK(within.improves({6, 0.99, Footing::stands}, {7, 0.1, Footing::stands}));
  CHECK_FALSE(within.improves({7, 0.1, Footing::stands}, {6, 0.99, Footing::stands}));
  CHECK(within.improves({7, 0.96, Footing::stands}, {7, 1.0, Footing::stands}));
  CHECK_FALSE(within.improves({7, 0.98, Footing::stands}, {7, 1.0, Footing::stands}));
  const Goal eight{.cables = 8};
  CHECK_FALSE(eight.improves({6, 1.0, Footing::stands}, {8, 1.0, Footing::stands}));
  CHECK(eight.improves({8, 0.9, Footing::stands}, {6, 1.0, Footing::stands}));
}

TEST_CASE("a goal that makes no sense is refused by the name of its field") {
  CHECK_THROWS_WITH((Goal{.max_error_percent = 0.0}.validate()),
                    Catch::Contains("max_error_percent"));
  CHECK_THROWS_WITH((Goal{.cables = -1}.validate()), Catch::Contains("cables"));
  CHECK_NOTHROW(Goal{}.validate());
}
