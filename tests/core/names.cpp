#include <catch2/catch.hpp>
#include <stdexcept>
#include <tencer/core/names.hpp>
#include <tencer/core/words.hpp>

using namespace tencer::core;

TEST_CASE("Rods have letters, cables and anchors numbers from 1") {
  CHECK(rod_name(0) == "A");
  CHECK(rod_name(25) == "Z");
  CHECK(rod_name(26) == "AA");
  CHECK(rod_name(701) == "ZZ");
  CHECK(rod_name(702) == "AAA");
  CHECK_THROWS_AS(rod_name(-1), std::invalid_argument);
  CHECK(cable_name(0) == "1");
  CHECK(anchor_name(2) == "anchor 3");
  CHECK(cable_in_words(11) == "cable 12");
}

TEST_CASE("The only rod needs no letter") {
  CHECK(rod_in_words(1, 2) == "rod B");
  CHECK(rods_in_words({0, 2}, 3) == "rods A and C");
  CHECK(rods_in_words({0, 1, 3}, 4) == "rods A, B and D");
  CHECK(rod_in_words(0, 1) == "the rod");
}

TEST_CASE("Places on rods are told together") {
  CHECK(places_in_words({{1, 83.912}}, 2, "cm") == "B at 83.91 cm");
  CHECK(places_in_words({{0, 8.3}, {0, 83.9}, {1, 2}}, 2, "cm") ==
        "A at 8.3 and 83.9 cm and B at 2 cm");
  CHECK(places_in_words({{0, 8}, {0, 83.9}}, 1, "mm") == "8 and 83.9 mm along the rod");
}

TEST_CASE("One thing is no things") {
  CHECK(counted(0, "cable") == "0 cables");
  CHECK(counted(1, "cable") == "1 cable");
  CHECK(counted(2, "cable") == "2 cables");
}
