#include "fabricate/words.hpp"

#include <catch2/catch.hpp>

#include "drawing/drawing.hpp"

using namespace tencer::app;

TEST_CASE("Numbers have three digits, as in view.html") {
  CHECK(significant(0) == "0");
  CHECK(significant(1) == "1");
  CHECK(significant(2.1234) == "2.12");
  CHECK(significant(9.996) == "10");
  CHECK(significant(0.0999999) == "0.1");
  CHECK(significant(-0.012345) == "-0.0123");
  CHECK(significant(123.4) == "123");
  CHECK(significant(99951) == "100000");
  CHECK(significant(12345) == "12300");
  CHECK(significant(1e5) == "1.00e+5");
  CHECK(significant(0.000123) == "1.23e-4");
}

TEST_CASE("Scales are round, and what is drawn fits") {
  CHECK(usual_scale({310, 100}, {100, 100}) == Approx(1 / 3.2));
  CHECK(usual_scale({1, 100}, {100, 50}) == Approx(0.5));
  CHECK(usual_scale({100, 100}, {100, 100}) == Approx(1));
  CHECK(usual_scale({30, 1}, {100, 100}) == Approx(3));
  CHECK(scale_words(1 / 3.2) == "1 : 3.2");
  CHECK(scale_words(1) == "1 : 1");
  CHECK(scale_words(3) == "3 : 1");
  for (double size = 0.01; size < 1e6; size *= 1.7) {
    const double scale = usual_scale({size, size / 3}, {150, 200});
    CHECK(scale * size <= 150 * (1 + 1e-9));
    CHECK(scale * size >= 150 / 2.01);
  }
}
