#include "fabricate/strokes.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

using namespace tencer::app;

namespace {

double length_of(const std::vector<Path>& strokes) {
  double sum = 0;
  for (const Path& stroke : strokes)
    sum += (stroke.rightCols(stroke.cols() - 1) - stroke.leftCols(stroke.cols() - 1))
               .colwise()
               .norm()
               .sum();
  return sum;
}

Path circle(double radius, int vertices) {
  Path points(2, vertices);
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * std::numbers::pi * i / vertices;
    points.col(i) = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return points;
}

}  // namespace

TEST_CASE("A line without gaps is one stroke, from its start to its end") {
  Path line(2, 3);
  line << 0, 3, 3, 0, 0, 4;
  const auto whole = strokes(line, false, {});
  REQUIRE(whole.size() == 1);
  CHECK(whole[0] == line);
  CHECK(length_of(strokes(line, true, {})) == Approx(3 + 4 + 5));
}

TEST_CASE("Gaps are left out where they are, also across the seam") {
  Path line(2, 2);
  line << 0, 10, 0, 0;
  const auto parts = strokes(line, false, {{7, 8}, {2, 3}, {2.5, 4}, {9, 20}});
  REQUIRE(parts.size() == 3);
  CHECK(parts[0].rightCols<1>().x() == Approx(2));
  CHECK(parts[1](0, 0) == Approx(4));
  CHECK(parts[1].rightCols<1>().x() == Approx(7));
  CHECK(parts[2](0, 0) == Approx(8));
  CHECK(parts[2].rightCols<1>().x() == Approx(9));

  const Path ring = circle(10, 60);
  const double around = length_of(strokes(ring, true, {}));
  const auto opened = strokes(ring, true, {{-2, 3}});
  REQUIRE(opened.size() == 1);
  CHECK(length_of(opened) == Approx(around - 5));
}

TEST_CASE("What is drawn and what is not make up the line") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(0, 60);
  const Path ring = circle(10, 200);
  const double around = length_of(strokes(ring, true, {}));
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Gap> gaps;
    for (int i = 0; i < 8; ++i) {
      const double at = place(random);
      gaps.push_back({at, at + 2});
    }
    // What the gaps cover, a hundredth at a time.
    const int steps = 100000;
    int covered = 0;
    for (int i = 0; i < steps; ++i) {
      const double s = around * i / steps;
      bool inside = false;
      for (const Gap& gap : gaps)
        for (const double turn : {0.0, around}) inside |= s + turn >= gap.from && s + turn < gap.to;
      covered += inside ? 1 : 0;
    }
    CHECK(length_of(strokes(ring, true, gaps)) ==
          Approx(around * (1 - static_cast<double>(covered) / steps)).margin(0.02));
  }
}

TEST_CASE("Points nearer than anyone sees are left out, and the shape stays") {
  const Path ring = circle(5, 100000);
  const auto drawn = strokes(ring, true, {});
  REQUIRE(drawn.size() == 1);
  CHECK(drawn[0].cols() < 300);
  for (const auto& point : drawn[0].colwise()) CHECK(point.norm() == Approx(5));
}
