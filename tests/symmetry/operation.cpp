#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/symmetry/group.hpp>

namespace tencer::symmetry {
namespace {

using springs::AtAnchor;
using springs::OnRod;

// Two closed rods of different length and an open one.
std::vector<geometry::ArcLength> three_rods() {
  return {{Eigen::VectorXd::Constant(10, 0.4), true},
          {Eigen::VectorXd::Constant(7, 0.57), true},
          {Eigen::VectorXd::Constant(5, 0.3), false}};
}

// Exchanges the closed rods, turns the open one round, and exchanges two anchors.
Operation exchange(const std::vector<geometry::ArcLength>& rods) {
  const double ratio = rods[1].length() / rods[0].length();
  return {.matrix = Eigen::Vector3d(-1, 1, 1).asDiagonal(),
          .translation = {1, 0, 0},
          .rods = {{1, -ratio, 0.7}, {0, -1.0 / ratio, 0.7 / ratio}, {2, -1.0, rods[2].length()}},
          .anchors = {1, 0, 2}};
}

}  // namespace

TEST_CASE("an end goes to its image, round closed rods and within open ones") {
  const auto rods = three_rods();
  const Operation operation = exchange(rods);
  const auto s_of = [](const springs::End& end) { return std::get<OnRod>(end).s; };
  CHECK(s_of(image(operation, OnRod{0, 0.0}, rods)) == 0.7);
  CHECK(std::get<OnRod>(image(operation, OnRod{0, 0.0}, rods)).rod == 1);
  CHECK(s_of(image(operation, OnRod{0, 1.0}, rods)) == Approx(0.7 - 0.9975 + 3.99));
  CHECK(s_of(image(operation, OnRod{0, 1.0 + 3 * 4.0}, rods)) == Approx(0.7 - 0.9975 + 3.99));
  CHECK(s_of(image(operation, OnRod{2, 0.0}, rods)) == rods[2].length());
  CHECK(s_of(image(operation, OnRod{2, 9.0}, rods)) == 0.0);
  CHECK(std::get<AtAnchor>(image(operation, AtAnchor{1}, rods)).anchor == 0);
  CHECK_THROWS_AS(image(operation, OnRod{3, 0.0}, rods), std::invalid_argument);
  CHECK_THROWS_AS(image(operation, AtAnchor{-1}, rods), std::invalid_argument);
}

TEST_CASE("a product does what its factors do in turn") {
  const auto rods = three_rods();
  const Operation flip = exchange(rods);
  Operation shift = identity(3, 3);
  shift.rods[0].offset = 3.3;
  shift.rods[1].offset = 2.1;
  shift.anchors = {2, 0, 1};
  const Operation product = compose(flip, shift, rods);
  for (int r = 0; r < 3; ++r) {
    for (const double part : {0.0, 0.3, 0.999}) {
      const springs::End end = OnRod{r, part * rods[r].length()};
      const auto at_once = std::get<OnRod>(image(product, end, rods));
      const auto in_turn = std::get<OnRod>(image(flip, image(shift, end, rods), rods));
      CHECK(at_once.rod == in_turn.rod);
      CHECK(at_once.s == Approx(in_turn.s).margin(1e-13));
    }
  }
  for (int i = 0; i < 3; ++i)
    CHECK(std::get<AtAnchor>(image(product, AtAnchor{i}, rods)).anchor ==
          flip.anchors[shift.anchors[i]]);
  const Operation twice = compose(flip, flip, rods);
  CHECK(twice.matrix.isIdentity(1e-15));
  CHECK(twice.translation.isZero(1e-15));
  for (int r = 0; r < 3; ++r) {
    CHECK(twice.rods[r].rod == r);
    CHECK(twice.rods[r].rate == 1.0);
    CHECK(std::abs(std::remainder(twice.rods[r].offset, rods[r].length())) < 1e-14);
  }
  CHECK_THROWS_AS(compose(flip, identity(2, 3), rods), std::invalid_argument);
}

TEST_CASE("a measured generator is moved onto the nearest exact one") {
  const double length = 4.0;
  const std::vector<geometry::ArcLength> rods{{Eigen::VectorXd::Constant(10, 0.4), true}};
  Operation fifth = identity(1, 0);
  fifth.matrix =
      Eigen::AngleAxisd(2 * std::numbers::pi / 5 + 3e-4, Eigen::Vector3d(1, 2, 3) / 3.7417)
          .toRotationMatrix();
  fifth.translation = {1, -1, 0.3334};
  fifth.rods[0].offset = 2 * length / 5 - 1e-3;
  const auto group = closure(std::vector<Operation>{fifth}, rods, 0);
  REQUIRE(group);
  REQUIRE(group->order() == 5);
  const Operation& exact = group->operations[1];
  CHECK((exact.matrix - fifth.matrix).norm() < 1e-3);
  CHECK(exact.rods[0].offset == Approx(2 * length / 5).epsilon(1e-12));
  CHECK(Eigen::AngleAxisd(exact.matrix).angle() == Approx(2 * std::numbers::pi / 5).epsilon(1e-12));
  Operation power = identity(1, 0);
  for (int i = 0; i < 5; ++i) power = compose(exact, power, rods);
  CHECK(power.matrix.isIdentity(1e-13));
  CHECK(power.translation.norm() < 1e-13);
}

TEST_CASE("a group has no more operations than allowed") {
  const std::vector<geometry::ArcLength> rods{{Eigen::VectorXd::Constant(10, 0.4), true}};
  Operation turn = identity(1, 0);
  turn.matrix =
      Eigen::AngleAxisd(2 * std::numbers::pi / 30, Eigen::Vector3d::UnitX()).toRotationMatrix();
  turn.rods[0].offset = 4.0 / 30;
  const std::vector<Operation> generators{turn};
  CHECK(closure(generators, rods, 0, 30)->order() == 30);
  const auto refused = closure(generators, rods, 0, 29);
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().message, Catch::Contains("more than 29"));
  CHECK(closure({}, rods, 2)->order() == 1);
}

}  // namespace tencer::symmetry
