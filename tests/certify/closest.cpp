// Least distances where they are plain.
#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/certify/closest.hpp>

#include "fixtures/bow.hpp"

using namespace tencer;

namespace {

// Two crossed rods of length 1, the second along y and 0.1 higher.
fixtures::Held crossed() {
  constexpr int vertices = 21;
  fixtures::Held held;
  held.structure.rods = {fixtures::slender_rod(vertices - 1, 1.0),
                         fixtures::slender_rod(vertices - 1, 1.0)};
  Eigen::Matrix3Xd over = Eigen::Matrix3Xd::Zero(3, vertices);
  over.row(0).setConstant(0.32);
  over.row(1) = Eigen::RowVectorXd::LinSpaced(vertices, -0.5, 0.5);
  over.row(2).setConstant(0.1);
  held.state = model::make_state(held.structure, {fixtures::straight(vertices, 1.0), over});
  return held;
}

}  // namespace

TEST_CASE("two crossed rods are as far apart as their lines, less their radii") {
  const auto held = crossed();
  const auto found = certify::closest(held.structure, held.state);
  // EA = 4e8 and EI = 1 are those of a solid circle of this radius.
  constexpr double radius = 1e-4;
  REQUIRE(found.rods);
  CHECK(found.rods->distance == Approx(0.1 - 2 * radius));
  CHECK(found.rods->s_a == Approx(0.32));
  CHECK(found.rods->s_b == Approx(0.5));
  CHECK_FALSE(found.cables);
  CHECK_FALSE(found.marks);
}

TEST_CASE("a cable that passes a rod is as far from it as the lines, less the rod's radius") {
  auto held = crossed();
  held.structure.anchors.resize(3, 1);
  held.structure.anchors.col(0) = Eigen::Vector3d(0.7, 0.2, -0.05);
  // From the end of the upper rod, over the lower one, which is along x.
  held.structure.cables = {{.a = springs::AtAnchor{0}, .b = springs::OnRod{1, 0.0}}};
  const auto found = certify::closest(held.structure, held.state);
  REQUIRE(found.cable_rod);
  const Eigen::Vector3d along = Eigen::Vector3d(0.32, -0.5, 0.1) - held.structure.anchors.col(0);
  const Eigen::Vector3d across = along.cross(Eigen::Vector3d::UnitX()).normalized();
  const double lines = std::abs(across.dot(held.structure.anchors.col(0)));
  CHECK(found.cable_rod->distance == Approx(lines - 1e-4));
  CHECK(found.cable_rod->cable == 0);
  CHECK(found.cable_rod->rod == 0);
}

TEST_CASE("cables that pass each other, and where they are tied") {
  auto held = crossed();
  held.structure.cables = {{.a = springs::OnRod{0, 0.0}, .b = springs::OnRod{0, 1.0}},
                           {.a = springs::OnRod{1, 0.0}, .b = springs::OnRod{1, 1.0}}};
  const auto found = certify::closest(held.structure, held.state);
  REQUIRE(found.cables);
  CHECK(found.cables->distance == Approx(0.1));
  REQUIRE(found.marks);
  CHECK(found.marks->distance == Approx(1.0));
}

TEST_CASE("a bow's own strands are none, and cables that share a place do not count") {
  auto bow = fixtures::bow();
  const auto found = certify::closest(bow.structure, bow.state);
  CHECK_FALSE(found.rods);
  REQUIRE(found.marks);
  CHECK(found.marks->distance == Approx(0.988 - 0.762));
  bow.structure.cables[1].a = bow.structure.cables[0].a;
  CHECK_FALSE(certify::closest(bow.structure, bow.state).cables);
}
