#include "drawing/strokes.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

using namespace tencer::app;

namespace {

double length_of(const std::vector<Stroke>& strokes) {
  double sum = 0;
  for (const auto& [line, from, to, slant_from, slant_to] : strokes)
    sum +=
        (line.rightCols(line.cols() - 1) - line.leftCols(line.cols() - 1)).colwise().norm().sum();
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
  CHECK(whole[0].line == line);
  CHECK(length_of(strokes(line, true, {})) == Approx(3 + 4 + 5));
}

TEST_CASE("Gaps are left out where they are, also across the seam") {
  Path line(2, 2);
  line << 0, 10, 0, 0;
  const auto parts = strokes(line, false, {{7, 8}, {2, 3}, {2.5, 4}, {9, 20}});
  REQUIRE(parts.size() == 3);
  CHECK(parts[0].line.rightCols<1>().x() == Approx(2));
  CHECK(parts[1].line(0, 0) == Approx(4));
  CHECK(parts[1].line.rightCols<1>().x() == Approx(7));
  CHECK(parts[2].line(0, 0) == Approx(8));
  CHECK(parts[2].line.rightCols<1>().x() == Approx(9));

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

TEST_CASE("A stroke goes on over the seam of a closed line") {
  const Path ring = circle(10, 60);
  const double around = length_of(strokes(ring, true, {}));
  const auto opened = strokes(ring, true, {{20, 23}});
  REQUIRE(opened.size() == 1);
  CHECK(opened[0].from == Approx(23));
  CHECK(opened[0].to == Approx(around + 20));
  CHECK(length_of(opened) == Approx(around - 3));
}

TEST_CASE("What is shorter than can be seen between two gaps is left out") {
  Path line(2, 2);
  line << 0, 10, 0, 0;
  CHECK(strokes(line, false, {{2, 3}, {3.5, 5}}).size() == 3);
  CHECK(strokes(line, false, {{2, 3}, {3.5, 5}}, 1).size() == 2);
}

TEST_CASE("A gap is as wide as what passes over it, its ends as slanted") {
  Path under(2, 2);
  under << -20, 20, 0, 0;
  const Eigen::VectorXd under_lengths = lengths_along(under, false);
  for (const double degrees : {90.0, 60.0, 120.0, 45.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    Path over(2, 2);
    over << -20 * std::cos(angle), 20 * std::cos(angle), -20 * std::sin(angle),
        20 * std::sin(angle);
    const Eigen::VectorXd over_lengths = lengths_along(over, false);
    const Gap gap = gap_under({over, over_lengths, 20}, {under, under_lengths, 20}, 1, 0.8);
    CHECK(20 - gap.from == Approx(1 / std::sin(angle)).margin(0.15));
    CHECK(gap.to - 20 == Approx(1 / std::sin(angle)).margin(0.15));
    // The outlines' corners at the gap are all as far from the line over.
    const auto parts = strokes(under, false, {gap});
    REQUIRE(parts.size() == 2);
    const Path left = outline(parts[0], 0.8);
    int corners = 0;
    for (const auto& corner : left.colwise()) {
      if (corner.x() < -10) continue;
      ++corners;
      const double away = std::sin(angle) * corner.x() - std::cos(angle) * corner.y();
      CHECK(std::abs(away) == Approx(1).margin(0.15));
    }
    CHECK(corners == 2);
  }
}

TEST_CASE("Where two lines part slowly the gap is long and its ends are not sharp") {
  Path under(2, 2);
  under << -20, 20, 0, 0;
  Path over(2, 2);
  over << -20, 20, -2, 2;
  const Gap gap = gap_under({over, lengths_along(over, false), 20 * std::hypot(1, 0.1)},
                            {under, lengths_along(under, false), 20}, 1, 0.8);
  CHECK(gap.to - gap.from > 12);
  CHECK(gap.to - gap.from < 22);
  CHECK(std::abs(gap.slant_to) <= 0.9 * 0.8);
}

TEST_CASE("Points nearer than anyone sees are left out, and the shape stays") {
  const Path ring = circle(5, 100000);
  const auto drawn = strokes(ring, true, {});
  REQUIRE(drawn.size() == 1);
  CHECK(drawn[0].line.cols() < 300);
  for (const auto& point : drawn[0].line.colwise()) CHECK(point.norm() == Approx(5));
}
