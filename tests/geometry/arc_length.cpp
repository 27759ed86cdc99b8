#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <tencer/geometry/arc_length.hpp>
#include <vector>

using tencer::geometry::ArcLength;
using tencer::geometry::Location;
using tencer::geometry::Side;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Eigen::VectorXd lengths(std::initializer_list<double> values) {
  Eigen::VectorXd result(values.size());
  std::copy(values.begin(), values.end(), result.data());
  return result;
}

// Edge lengths over six orders of magnitude.
Eigen::VectorXd random_lengths(std::mt19937& random, int n) {
  std::uniform_real_distribution<double> exponent(-3.0, 3.0);
  Eigen::VectorXd result(n);
  for (double& length : result) length = std::pow(10.0, exponent(random));
  return result;
}

void check_location(const Location& found, int edge, double t) {
  CHECK(found.edge == edge);
  CHECK(found.t == t);
}

}  // namespace

TEST_CASE("closed: the seam, whole turns and negative arc lengths are exact") {
  const ArcLength arc(lengths({1.0, 2.0, 0.5, 0.5}), true);
  REQUIRE(arc.length() == 4.0);
  for (int turns = -3; turns <= 3; ++turns) {
    CAPTURE(turns);
    const double whole = 4.0 * turns;
    CHECK(arc.wrap(whole) == 0.0);
    CHECK_FALSE(std::signbit(arc.wrap(whole)));
    check_location(arc.locate(whole), 0, 0.0);
    check_location(arc.locate(whole, Side::before), 3, 1.0);
    check_location(arc.locate(whole + 1.5), 1, 0.25);
    check_location(arc.locate(whole - 0.125), 3, 0.75);
  }
}

TEST_CASE("closed: just below the length stays in the last edge, beyond it starts the first") {
  std::mt19937 random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const ArcLength arc(random_lengths(random, 3 + trial), true);
    const double length = arc.length();
    const double below = std::nextafter(length, 0.0);
    CHECK(arc.wrap(below) == below);
    CHECK(arc.locate(below).edge == arc.edges() - 1);
    const double last = arc.edge_length(arc.edges() - 1);
    CHECK(std::abs(1.0 - arc.locate(below).t - (length - below) / last) < 1e-15);
    CHECK(arc.wrap(length) == 0.0);
    CHECK(arc.wrap(-length) == 0.0);
    const double above = std::nextafter(length, infinity);
    CHECK(arc.wrap(above) == above - length);
    CHECK(arc.locate(above).edge == 0);
    // Too close below zero for a double below the length to tell: the seam.
    CHECK(arc.wrap(-std::numeric_limits<double>::denorm_min()) == 0.0);
  }
}

TEST_CASE("closed: the wrapped arc length is in [0, L) and periodic") {
  std::mt19937 random(2);
  for (int trial = 0; trial < 2000; ++trial) {
    const ArcLength arc(random_lengths(random, 5), true);
    const double length = arc.length();
    const double s = std::uniform_real_distribution<double>(-length, 2.0 * length)(random);
    const int turns = std::uniform_int_distribution<int>(-1000, 1000)(random);
    const double shifted = s + turns * length;
    const double a = arc.wrap(s);
    const double b = arc.wrap(shifted);
    REQUIRE((a >= 0.0 && a < length && b >= 0.0 && b < length));
    REQUIRE(arc.wrap(b) == b);
    // The only difference is the rounding of s + turns L itself; near the seam it may cross it.
    const double apart = std::abs(a - b);
    const double rounding =
        4.0 * std::numeric_limits<double>::epsilon() * (std::abs(turns) + 2.0) * length;
    REQUIRE(std::min(apart, length - apart) <= rounding);
  }
}

TEST_CASE("at a vertex both sides name it, from the edge before and the edge after") {
  std::mt19937 random(3);
  for (const bool closed : {true, false}) {
    const ArcLength arc(random_lengths(random, 20), closed);
    for (int vertex = 1; vertex < arc.edges(); ++vertex) {
      const double s = arc.knots()[vertex];
      check_location(arc.locate(s, Side::after), vertex, 0.0);
      check_location(arc.locate(s, Side::before), vertex - 1, 1.0);
      const double below = std::nextafter(s, 0.0);
      CHECK(arc.locate(below, Side::after).edge == vertex - 1);
      CHECK(arc.locate(below, Side::before).edge == vertex - 1);
      const double above = std::nextafter(s, infinity);
      CHECK(arc.locate(above, Side::before).edge == vertex);
    }
  }
}

TEST_CASE("open: arc lengths are clamped to the ends") {
  const ArcLength arc(lengths({1.0, 2.0, 1.0}), false);
  for (const double s : {0.0, -1e-300, -5.0}) {
    check_location(arc.locate(s), 0, 0.0);
    check_location(arc.locate(s, Side::before), 0, 0.0);
  }
  for (const double s : {4.0, std::nextafter(4.0, 5.0), 1e300}) {
    check_location(arc.locate(s), 2, 1.0);
    check_location(arc.locate(s, Side::before), 2, 1.0);
  }
  check_location(arc.locate(2.0), 1, 0.5);
}

TEST_CASE("a location reproduces its arc length and t stays in [0, 1]") {
  std::mt19937 random(4);
  for (int trial = 0; trial < 2000; ++trial) {
    const ArcLength arc(random_lengths(random, 8), trial % 2 == 0);
    const double s = std::uniform_real_distribution<double>(0.0, arc.length())(random);
    for (const Side side : {Side::after, Side::before}) {
      const Location found = arc.locate(s, side);
      REQUIRE((found.t >= 0.0 && found.t <= 1.0));
      const double again = arc.knots()[found.edge] + found.t * arc.edge_length(found.edge);
      REQUIRE(std::abs(again - arc.wrap(s)) <= 1e-15 * arc.length());
    }
  }
}

TEST_CASE("unusable edge lengths and arc lengths are a caller's mistake") {
  CHECK_THROWS_AS(ArcLength(Eigen::VectorXd(), true), std::invalid_argument);
  CHECK_THROWS_AS(ArcLength(lengths({1.0, 0.0}), false), std::invalid_argument);
  CHECK_THROWS_AS(ArcLength(lengths({1.0, -1.0}), false), std::invalid_argument);
  CHECK_THROWS_AS(ArcLength(lengths({1.0, infinity}), false), std::invalid_argument);
  const ArcLength arc(lengths({1.0, 1.0, 1.0}), true);
  CHECK_THROWS_AS(arc.wrap(std::nan("")), std::invalid_argument);
  CHECK_THROWS_AS(arc.locate(infinity), std::invalid_argument);
}
