#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/model/clearance.hpp>

using namespace tencer;

namespace {

constexpr double radius = 0.1;

der::Rod straight_rod(int edges, double length) {
  der::Rod rod;
  rod.section = der::solid_circle(1.0, 0.3, radius);
  rod.rest_lengths = Eigen::VectorXd::Constant(edges, length / edges);
  return rod;
}

// Two rods along x, the second `apart` above the first.
struct TwoRods {
  model::Structure structure;
  model::State state;

  explicit TwoRods(double apart) {
    Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, 21);
    x.row(0) = Eigen::RowVectorXd::LinSpaced(21, 0, 10);
    Eigen::Matrix3Xd above = x;
    above.row(2).setConstant(apart);
    structure.rods = {straight_rod(20, 10), straight_rod(20, 10)};
    structure.anchors = Eigen::Matrix3Xd(3, 2);
    structure.anchors << 4.3, 4.3, -3, 3, 0.05, 0.25;
    state = make_state(structure, {x, above});
  }
};

}  // namespace

TEST_CASE("The outer radius of a round rod is its radius") {
  const TwoRods rods(1);
  CHECK(model::outer_radii(rods.structure)[1] == Approx(radius));
}

TEST_CASE("A cable across a rod passes where the two lines are nearest") {
  const TwoRods rods(1);
  const springs::Cable across{.a = springs::AtAnchor{0}, .b = springs::AtAnchor{1}};
  const model::CablePasses passes(rods.structure, rods.state);
  const auto found = passes.of(across, 7);
  REQUIRE(found.size() == 2);
  CHECK(found[0].cable == 7);
  CHECK(found[0].rod == 0);
  CHECK(found[0].edge == 8);
  CHECK(found[0].t == Approx(0.6));
  CHECK(found[0].u == Approx(0.5).margin(0.02));
  // The line goes up by 0.2 on a length of 6 and is 0.15 above the rod in the middle.
  CHECK(found[0].distance == Approx(0.15 * 6 / std::hypot(6, 0.2)));
  CHECK(found[0].away.z() > 0.99);
  CHECK(found[1].distance == Approx(0.85 * 6 / std::hypot(6, 0.2)));
  CHECK(found[1].away.z() < -0.99);
  CHECK_FALSE(passes.clear(across));  // 0.2 are asked for
  CHECK(passes.missing(found[0]) > 0);
  CHECK(passes.missing(found[1]) < 0);
  CHECK(passes.of(across, 0, 1.0).size() == 1);
}

TEST_CASE("Beside its own end a cable may be near its rod, not further on") {
  const TwoRods rods(1);
  const model::CablePasses passes(rods.structure, rods.state);
  // Up by 1 on a length of d: beyond 0.6 to either side of the end the rod is this near.
  for (const double d : {1.0, 2.0, 4.0}) {
    const springs::Cable cable{.a = springs::OnRod{0, 3.0}, .b = springs::OnRod{1, 3.0 + d}};
    const auto found = passes.of(cable);
    REQUIRE(found.size() == 4);  // before and behind its end on each of the rods
    CHECK(found[1].distance == Approx(0.6 / std::hypot(1, d)));
    CHECK(found[1].edge + found[1].t == Approx(3.6 / 0.5));
    CHECK(passes.clear(cable) == (d < 2.5));
  }
}

TEST_CASE("A rod's seam is no end of it") {
  constexpr int n = 40;
  const double edge = 2 * std::sin(std::numbers::pi / n);
  der::Rod ring = straight_rod(n, n * edge);
  ring.closed = true;
  Eigen::Matrix3Xd x(3, n);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    x.col(i) << std::cos(angle), std::sin(angle), 0;
  }
  model::Structure structure;
  structure.rods = {ring};
  const model::State state = make_state(structure, {x});
  const model::CablePasses passes(structure, state);
  const double length = n * edge;
  // The chord of a tenth of the circle leaves the rod too flat, one across it does not; so it is
  // wherever the seam is.
  for (const double s : {0.0, 0.3 * length, 0.97 * length}) {
    CHECK_FALSE(passes.clear({.a = springs::OnRod{0, s}, .b = springs::OnRod{0, s + length / 10}}));
    CHECK(passes.clear({.a = springs::OnRod{0, s}, .b = springs::OnRod{0, s + length / 2}}));
  }
}

TEST_CASE("The bend that a chain of vertices cuts off counts") {
  constexpr int n = 13;  // the middle of an edge is on top
  Eigen::Matrix3Xd x(3, n + 1);
  for (int i = 0; i <= n; ++i) {
    const double angle = std::numbers::pi * i / n;
    x.col(i) << std::cos(angle), std::sin(angle), 0;
  }
  model::Structure structure;
  structure.rods = {straight_rod(n, 2 * n * std::sin(std::numbers::pi / n / 2))};
  structure.anchors = Eigen::Matrix3Xd(3, 4);
  structure.anchors << -5, 5, 0, 0, 1.5, 1.5, 0, 0.5, 0, 0, 0, 0;
  const model::State state = make_state(structure, {x});
  const model::CablePasses passes(structure, state);
  const double sagitta = 1 - std::cos(std::numbers::pi / n / 2);
  // Both are 0.5 from the circle: one is nearer than to the chain, one further away.
  const auto outside = passes.of({.a = springs::AtAnchor{0}, .b = springs::AtAnchor{1}});
  REQUIRE(outside.size() == 1);
  CHECK(outside[0].distance == Approx(0.5).margin(0.02 * sagitta));
  const auto inside = passes.of({.a = springs::AtAnchor{2}, .b = springs::AtAnchor{3}});
  REQUIRE(inside.size() == 1);
  CHECK(inside[0].distance == Approx(0.5).margin(0.02 * sagitta));
}

TEST_CASE("Gaps are not negative") {
  const TwoRods rods(1);
  CHECK_THROWS_AS(model::CablePasses(rods.structure, rods.state, {.clearance = -1}),
                  std::invalid_argument);
}

TEST_CASE("Marks are paired along their rod, across the seam of a closed one") {
  der::Rod ring = straight_rod(20, 10);
  ring.closed = true;
  model::Structure structure;
  structure.rods = {ring, straight_rod(20, 10)};
  const std::vector<springs::Cable> cables{
      {.a = springs::OnRod{0, 9.5}, .b = springs::OnRod{1, 2}},
      {.a = springs::OnRod{1, 7}, .b = springs::OnRod{0, 11}},  // wraps to 1
      {.a = springs::OnRod{0, 4}, .b = springs::AtAnchor{0}}};
  const auto pairs = model::neighbouring_marks(cables, arc_lengths(structure));
  REQUIRE(pairs.size() == 4);
  CHECK(pairs[0].apart == Approx(3));    // 1 to 4
  CHECK(pairs[1].apart == Approx(5.5));  // 4 to 9.5
  CHECK(pairs[2].apart == Approx(1.5));  // 9.5 to 1
  CHECK(pairs[2].first.cable == 0);
  CHECK(pairs[2].second.cable == 1);
  CHECK(pairs[2].second.end == 1);
  CHECK(pairs[3].rod == 1);
  CHECK(pairs[3].apart == Approx(5));
}
