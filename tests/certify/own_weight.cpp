// Sag against beams under their own weight.
#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/certify/own_weight.hpp>
#include <tencer/sensitivity/distance.hpp>

#include "fixtures/bow.hpp"

using namespace tencer;
using Catch::Matchers::WithinRel;

namespace {

constexpr int edges = 80;
constexpr double weight = 1e-3;

model::Structure straight_rod() {
  model::Structure rod;
  rod.planar = true;
  rod.rods = {fixtures::slender_rod(edges, 1.0)};
  return rod;
}

certify::Sag sag_of(const model::Structure& structure) {
  return certify::own_weight_sag(structure,
                                 model::make_state(structure, {fixtures::straight(edges + 1, 1.0)}),
                                 Eigen::VectorXd(0), Eigen::VectorXd::Constant(1, weight));
}

}  // namespace

TEST_CASE("a clamped rod sags as a beam") {
  model::Structure rod = straight_rod();
  rod.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 1}};
  const auto sag = sag_of(rod);
  REQUIRE(sag.computed);
  CHECK(sag.at.empty());
  // A clamp is felt in the middle of the edge that is held.
  CHECK_THAT(sag.deviation, WithinRel(weight * std::pow(1 - 0.5 / edges, 4) / 8, 2e-3));
}

TEST_CASE("a straight rod hangs along itself") {
  const auto sag = sag_of(straight_rod());
  REQUIRE(sag.computed);
  REQUIRE(sag.at.size() == 1);
  CHECK(sag.deviation < 1e-12);
}

TEST_CASE("a bow sags as one that is hung from that vertex and let settle") {
  const auto bow = fixtures::bow();
  const auto& x = bow.state[0].x;
  const Eigen::VectorXd weights = Eigen::VectorXd::Constant(1, weight);
  // One try: the first vertex.
  const auto sag = certify::own_weight_sag(bow.structure, bow.state, bow.tensions, weights, 1);
  REQUIRE(sag.computed);
  CHECK(sag.at.at(0).vertex == 0);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  const auto n = x.cols();
  for (Eigen::Index j = 0; j + 1 < n; ++j)
    middle += (x.col(j) + x.col(j + 1)) / 2 / static_cast<double>(n - 1);
  auto hung = bow.structure;
  hung.pins = {{.rod = 0, .vertex = 0}};
  hung.line_loads = {{.rod = 0, .force_per_length = weight * (middle - x.col(0)).normalized()}};
  const auto settled = equilibrium::relax_inextensible(hung, bow.state);
  REQUIRE(settled.equilibrium.usable());
  const auto target = model::make_target(bow.structure, {x});
  CHECK_THAT(sag.deviation,
             WithinRel(sensitivity::deviation(target, settled.equilibrium.state).max, 1e-3));

  const auto best = certify::own_weight_sag(bow.structure, bow.state, bow.tensions, weights);
  CHECK(best.deviation < sag.deviation);
}

TEST_CASE("what swings on its supports has no sag") {
  model::Structure rod = straight_rod();
  rod.pins = {{.rod = 0, .vertex = 0}};
  CHECK_FALSE(sag_of(rod).computed);
}
