#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/motion/tying.hpp>

#include "fixtures/bow.hpp"

using namespace tencer;
using std::numbers::pi;

TEST_CASE("a bow is strung cable by cable, from a straight rod on") {
  const auto bow = fixtures::bow();
  const auto plan = motion::tying_plan(bow.structure, bow.state, bow.tensions);
  CHECK(plan.finished);
  CHECK(plan.held.empty());
  REQUIRE(plan.steps.size() == 2);
  // Before the first the rod is straight.
  const auto& x = plan.steps[0].before[0].x;
  CHECK((x.col(0) - x.col(x.cols() - 1)).norm() == Approx(1).epsilon(1e-6));
  CHECK(plan.steps[0].moved > 0.1);
  CHECK(plan.steps[1].tension == Approx(bow.tensions[plan.steps[1].cable]));
  CHECK(plan.steps[0].cable != plan.steps[1].cable);
  for (const auto& step : plan.steps) CHECK(step.parts == 1);
}

TEST_CASE("the tension of a string that is tied alone is the elastica's load") {
  constexpr int vertices = 41;
  const auto known = fixtures::elastica(vertices, 0.9);
  model::Structure bow{
      .rods = {fixtures::slender_rod(vertices - 1, 1.0)},
      .cables = {{.a = springs::OnRod{0, 0.0},
                  .b = springs::OnRod{0, 1.0},
                  .rest_length = (known.x.col(vertices - 1) - known.x.col(0)).norm()}},
      .planar = true};
  const auto held = fixtures::settled(bow, known.x);
  const auto plan = motion::tying_plan(held.structure, held.state, held.tensions);
  REQUIRE(plan.steps.size() == 1);
  CHECK(plan.steps[0].tension == Approx(known.load).epsilon(2e-3));
}

TEST_CASE("what snaps when its string is let go has to be held") {
  // An arch that hangs through below its hinges, under a load that is a tenth more than what makes
  // it snap up; a string beside its middle keeps it from that.
  constexpr int vertices = 41;
  constexpr double at = 0.2;
  const double height = 0.04, span = 1 - height * height * pi * pi / 4;
  const double load = 1.1 * 16 * std::pow(pi, 3) * height / std::sqrt(12.0);
  model::Structure arch{.rods = {fixtures::slender_rod(vertices - 1, 1.0)},
                        .anchors = Eigen::Vector3d(at * span, -0.5, 0),
                        .cables = {{.a = springs::OnRod{0, at},
                                    .b = springs::AtAnchor{0},
                                    .rest_length = 0.5 - 0.9 * height * std::sin(pi * at)}},
                        .pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = vertices - 1}},
                        .point_loads = {{.s = 0.5, .force = {0, load, 0}}},
                        .planar = true};
  Eigen::Matrix3Xd x = fixtures::straight(vertices, span);
  for (int i = 0; i < vertices; ++i) x(1, i) = -height * std::sin(pi * x(0, i) / span);
  const auto held = fixtures::settled(arch, x);
  REQUIRE(held.tensions[0] > 0);
  REQUIRE(held.state[0].x(1, vertices / 2) < -0.8 * height);
  const auto plan = motion::tying_plan(held.structure, held.state, held.tensions);
  CHECK(plan.finished);
  REQUIRE(plan.held.size() == 1);
  CHECK(plan.held[0].obstacle == motion::Obstacle::falls);
  CHECK(plan.steps.empty());
}

TEST_CASE("rods that a cable alone ties together come apart with it") {
  model::Structure pair{.rods = {fixtures::slender_rod(20, 1.0), fixtures::slender_rod(20, 1.0)},
                        .planar = true};
  // Two arcs tied to lenses: each with its own string, and a cable between them.
  const auto arc = fixtures::elastica(21, 0.8);
  Eigen::Matrix3Xd below = arc.x;
  below.row(1).array() -= 1;
  const double chord = (arc.x.col(20) - arc.x.col(0)).norm();
  pair.cables = {{.a = springs::OnRod{0, 0.0}, .b = springs::OnRod{0, 1.0}, .rest_length = chord},
                 {.a = springs::OnRod{1, 0.0}, .b = springs::OnRod{1, 1.0}, .rest_length = chord},
                 {.a = springs::OnRod{0, 0.0}, .b = springs::OnRod{1, 0.0}, .rest_length = 1.0}};
  auto state = model::make_state(pair, {arc.x, below});
  auto found = equilibrium::relax_inextensible(pair, state);
  const auto plan = motion::tying_plan(pair, found.equilibrium.state, found.tensions);
  CHECK(plan.held.empty());
  REQUIRE(plan.steps.size() == 3);
  const auto tie = std::ranges::find(plan.steps, 2, &motion::Tied::cable);
  REQUIRE(tie != plan.steps.end());
  CHECK(tie->parts == 2);
}
