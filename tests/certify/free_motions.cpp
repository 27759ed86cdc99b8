// What supports leave free, in structures where it is plain.
#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/certify/free_motions.hpp>

#include "fixtures/bow.hpp"

using namespace tencer;
using Catch::Matchers::Contains;

namespace {

// Rods like the bow, side by side along z.
fixtures::Held arches(int count) {
  fixtures::Held held;
  std::vector<Eigen::Matrix3Xd> x;
  for (int r = 0; r < count; ++r) {
    held.structure.rods.push_back(fixtures::slender_rod(20, 1.0));
    x.push_back(fixtures::elastica(21, 1.0).x);
    x.back().row(2).array() += r;
  }
  held.state = model::make_state(held.structure, x);
  return held;
}

}  // namespace

TEST_CASE("an arch pinned at its ends swings about the line through them") {
  auto arch = arches(1);
  arch.structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 20}};
  const auto groups = certify::free_groups(arch.structure, arch.state);
  REQUIRE(groups.size() == 1);
  REQUIRE(groups[0].motions.size() == 1);
  const auto& swing = groups[0].motions[0];
  CHECK(swing.turns);
  const Eigen::Vector3d first = arch.state[0].x.col(0);
  const Eigen::Vector3d line = (arch.state[0].x.col(20) - first).normalized();
  CHECK(swing.direction.cross(line).norm() < 1e-6);
  CHECK((swing.point - first).cross(line).norm() < 1e-6);
  CHECK_THAT(certify::describe(groups[0], 1), Contains("the rod turns about the line through ("));
}

TEST_CASE("an arch on rollers shifts along them") {
  auto arch = arches(1);
  arch.structure.pins = {{.rod = 0, .vertex = 0, .axes = {false, true, true}},
                         {.rod = 0, .vertex = 10, .axes = {false, true, true}},
                         {.rod = 0, .vertex = 20, .axes = {false, true, true}}};
  const auto groups = certify::free_groups(arch.structure, arch.state);
  REQUIRE(groups.size() == 1);
  REQUIRE(groups[0].motions.size() == 1);
  CHECK_FALSE(groups[0].motions[0].turns);
  CHECK(groups[0].motions[0].direction.cross(Eigen::Vector3d::UnitX()).norm() < 1e-6);
  CHECK(certify::describe(groups[0], 1).starts_with("the rod shifts along ("));
}

TEST_CASE("one pin leaves three turns about it") {
  auto arch = arches(1);
  arch.structure.pins = {{.rod = 0, .vertex = 7}};
  const auto groups = certify::free_groups(arch.structure, arch.state);
  REQUIRE(groups.size() == 1);
  REQUIRE(groups[0].motions.size() == 3);
  const Eigen::Vector3d pinned = arch.state[0].x.col(7);
  for (const auto& turn : groups[0].motions) {
    CHECK(turn.turns);
    CHECK((turn.point - pinned).cross(turn.direction).norm() < 1e-6);
  }
}

TEST_CASE("groups that nothing ties together are named") {
  auto pair = arches(3);
  pair.structure.cables = {{.a = springs::OnRod{0, 0.5}, .b = springs::OnRod{2, 0.5}}};
  const auto groups = certify::free_groups(pair.structure, pair.state);
  REQUIRE(groups.size() == 2);
  CHECK(groups[0].rods == std::vector<int>{0, 2});
  CHECK(certify::describe(groups[0], 3) == "rods A and C move freely");
  CHECK(certify::describe(groups[1], 3) == "rod B moves freely");
}

TEST_CASE("what moves as a whole or not at all is no group that moves") {
  auto arch = arches(1);
  CHECK(certify::free_groups(arch.structure, arch.state).empty());
  arch.structure.pins = {
      {.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 10}, {.rod = 0, .vertex = 20}};
  CHECK(certify::free_groups(arch.structure, arch.state).empty());
}
