// What structures stand on.
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/certify/own_weight.hpp>
#include <tencer/certify/stance.hpp>
#include <tencer/equilibrium/inextensible.hpp>

#include "fixtures/bow.hpp"

using namespace tencer;
using Catch::Matchers::WithinRel;

namespace {

const Eigen::VectorXd own_weight = Eigen::VectorXd::Constant(1, 1e-3);

Eigen::Matrix3d feet_of(const certify::Stance& stance, const model::State& state) {
  Eigen::Matrix3d feet;
  for (int k = 0; k < 3; ++k) feet.col(k) = state[stance.feet[k].rod].x.col(stance.feet[k].vertex);
  return feet;
}

// A closed rod of straight edges through `x`.
model::Structure closed_rod(const Eigen::Matrix3Xd& x) {
  model::Structure structure;
  der::Rod rod = fixtures::slender_rod(static_cast<int>(x.cols()), 1.0);
  rod.closed = true;
  for (Eigen::Index i = 0; i < x.cols(); ++i)
    rod.rest_lengths[i] = (x.col((i + 1) % x.cols()) - x.col(i)).norm();
  structure.rods = {rod};
  return structure;
}

}  // namespace

// A (2,3) torus knot, turned.
Eigen::Matrix3Xd knot(double tilt) {
  Eigen::Matrix3Xd x(3, 90);
  for (int i = 0; i < 90; ++i) {
    const double angle = 2 * std::numbers::pi * i / 90;
    const double out = 2 + std::cos(3 * angle);
    x.col(i) << out * std::cos(2 * angle), out * std::sin(2 * angle), std::sin(3 * angle);
  }
  return Eigen::AngleAxisd(tilt, Eigen::Vector3d(1, 2, 0.5).normalized()).toRotationMatrix() * x;
}

Eigen::Matrix3Xd ring(int vertices) {
  Eigen::Matrix3Xd x(3, vertices);
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * std::numbers::pi * i / vertices;
    x.col(i) << std::cos(angle), std::sin(angle), 0;
  }
  return x;
}

TEST_CASE("a structure stands on vertices that all others are above, its centre of mass between") {
  for (const double tilt : {0.0, 0.4, 1.3, 2.2, 3.1}) {
    const Eigen::Matrix3Xd x = knot(tilt);
    const model::Structure structure = closed_rod(x);
    const model::State state = model::make_state(structure, {x});
    const auto stance = certify::stance(structure, state, own_weight);
    REQUIRE(stance);
    const Eigen::Matrix3d feet = feet_of(*stance, state);
    const Eigen::RowVectorXd below =
        stance->down.transpose() * (state[0].x.colwise() - feet.col(0));
    CHECK(below.maxCoeff() < 1e-9);
    const Eigen::Vector3d centre = certify::centre_of_mass(structure, state, own_weight);
    // The centre as a sum of the feet and a part of `down`.
    Eigen::Matrix4d rows = Eigen::Matrix4d::Zero();
    rows << feet, stance->down, 1, 1, 1, 0;
    const Eigen::Vector4d shares = rows.lu().solve(centre.homogeneous());
    CHECK(shares.head<3>().minCoeff() > 0);
  }
}

TEST_CASE("a cube's edges fall onto a face, wherever they are let go") {
  // Along edges of a unit cube through all its corners.
  Eigen::Matrix3Xd x(3, 8);
  x << 0, 1, 1, 0, 0, 1, 1, 0,  //
      0, 0, 1, 1, 1, 1, 0, 0,   //
      0, 0, 0, 0, 1, 1, 1, 1;
  for (const double tilt : {0.1, 0.5, 0.9, 1.4}) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(tilt, Eigen::Vector3d(1, 0.3, 0).normalized()).toRotationMatrix();
    const model::Structure structure = closed_rod(x);
    const auto stance =
        certify::stance(structure, model::make_state(structure, {turn * x}), own_weight);
    REQUIRE(stance);
    CHECK((turn.transpose() * stance->down).cwiseAbs().maxCoeff() == Approx(1));
  }
}

TEST_CASE("what lies in an upright plane does not stand") {
  const Eigen::Matrix3Xd upright =
      Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitX()).toRotationMatrix() *
      ring(20);
  const model::Structure structure = closed_rod(upright);
  CHECK_FALSE(certify::stance(structure, model::make_state(structure, {upright}), own_weight));
}

TEST_CASE("a ring on three feet sags to first order, and settles under more weight") {
  // At rest bent as it is: a circle needs no cables.
  const Eigen::Matrix3Xd x = ring(60);
  const model::Structure structure = closed_rod(x);
  const model::State state = model::make_state(structure, {x});
  const certify::Stance stance{.feet = {{{0, 0}, {0, 20}, {0, 40}}}};
  const auto sag_of = [&](double own_weight) {
    return certify::standing_sag(structure, state, Eigen::VectorXd(0),
                                 Eigen::VectorXd::Constant(1, own_weight), stance);
  };
  const auto settled_under = [&](double own_weight) {
    model::Structure loaded = structure;
    for (const auto& foot : stance.feet) loaded.pins.push_back({.rod = 0, .vertex = foot.vertex});
    loaded.line_loads = {{.rod = 0, .force_per_length = {0, 0, -own_weight}}};
    const auto settled = equilibrium::relax_inextensible(loaded, state);
    REQUIRE(settled.equilibrium.usable());
    return (settled.equilibrium.state[0].x - x).colwise().norm().maxCoeff();
  };
  const auto light = sag_of(1e-4);
  REQUIRE(light.computed);
  CHECK_FALSE(light.settled);
  CHECK(light.at.size() == 3);
  CHECK_THAT(light.deviation, WithinRel(settled_under(1e-4), 1e-3));
  CHECK_THAT(sag_of(2e-4).deviation, WithinRel(2 * light.deviation, 1e-9));

  const double own_weight = 1e-4 * 0.1 / light.deviation;
  const auto far = sag_of(own_weight);
  REQUIRE(far.computed);
  CHECK(far.settled);
  CHECK_FALSE(far.falls);
  CHECK_THAT(far.deviation, WithinRel(settled_under(own_weight), 1e-6));
}
