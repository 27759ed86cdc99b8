#include <Eigen/Geometry>
#include <array>
#include <catch2/catch.hpp>
#include <tencer/curves/analytic.hpp>
#include <tencer/curves/braid.hpp>
#include <tencer/curves/knots.hpp>
#include <tencer/fabricate/threading.hpp>

using namespace tencer;
using geometry::Polyline;

namespace {

Polyline ring(const Eigen::Vector3d& centre, bool upright) {
  Polyline curve = curves::circle(1.0, 40);
  if (upright) curve.points.row(1).swap(curve.points.row(2));
  curve.points.colwise() += centre;
  return curve;
}

}  // namespace

TEST_CASE("Rings through each other are linked, beside each other not") {
  const auto linked = fabricate::threading(
      std::vector{ring({0, 0, 0}, false), ring({1, 0, 0}, true), ring({5, 0, 0.3}, true)});
  REQUIRE(linked.pairs.size() == 1);
  CHECK(linked.pairs[0].a == 0);
  CHECK(linked.pairs[0].b == 1);
  CHECK(std::abs(linked.pairs[0].linking_number) == 1);
  for (const bool knotted : linked.knotted) CHECK_FALSE(knotted);
}

TEST_CASE("An open rod is threaded at any time") {
  std::vector rods{ring({0, 0, 0}, false), ring({1, 0, 0}, true)};
  rods[1].closed = false;
  CHECK(fabricate::threading(rods).pairs.empty());
}

TEST_CASE("Twin trefoils wind about each other six times, and each is a knot") {
  const auto twins = fabricate::threading(curves::twin_trefoils(3.0, 1.0, 80));
  REQUIRE(twins.pairs.size() == 1);
  CHECK(std::abs(twins.pairs[0].linking_number) == 6);
  CHECK(twins.knotted[0]);
  CHECK(twins.knotted[1]);
}

TEST_CASE("Turned round, a rod links the other way") {
  auto rods = curves::twin_trefoils(3.0, 1.0, 80);
  const int forward = fabricate::threading(rods).pairs.at(0).linking_number;
  rods[1].points = rods[1].points.rowwise().reverse().eval();
  CHECK(fabricate::threading(rods).pairs.at(0).linking_number == -forward);
}

TEST_CASE("Borromean rings are threaded, though no two of them have a linking number") {
  const auto rings = fabricate::threading(curves::borromean_ellipses(2.0, 1.0, 60));
  REQUIRE(rings.pairs.size() == 3);
  for (const auto& pair : rings.pairs) CHECK(pair.linking_number == 0);
}

TEST_CASE("Knots are told from rings, however they are turned") {
  std::vector<Polyline> rods{curves::torus_knot(5, 3, 3.0, 1.0, 200),
                             curves::trefoil(curves::TrefoilForm::torus_3_2, 1.0, 90),
                             curves::ellipse(2.0, 1.0, 60)};
  rods[2].points.row(2) = (3 * rods[2].points.row(0)).array().sin().matrix();
  for (int i = 0; i < 8; ++i) {
    const Eigen::Matrix3d turned =
        Eigen::AngleAxisd(0.8 * i, Eigen::Vector3d(1, i, 2).normalized()).toRotationMatrix();
    for (std::size_t r = 0; r < rods.size(); ++r) {
      Polyline rod = rods[r];
      rod.points = turned * rod.points;
      CHECK(fabricate::threading(std::vector{rod}).knotted[0] == (r < 2));
      // Its mirror image is what it is.
      rod.points.row(0) *= -1;
      CHECK(fabricate::threading(std::vector{rod}).knotted[0] == (r < 2));
    }
  }
}

TEST_CASE("No knot of up to seven crossings is taken for a ring") {
  for (const curves::KnotBraid& braid : curves::knot_table()) {
    const auto rods = std::vector{curves::braid_closure(braid.strands, braid.word)};
    INFO(braid.name);
    CHECK(fabricate::threading(rods).knotted[0]);
  }
  // Two strands that cross once are a ring with a kink.
  CHECK_FALSE(
      fabricate::threading(std::vector{curves::braid_closure(2, std::array{1})}).knotted[0]);
  CHECK_FALSE(
      fabricate::threading(std::vector{curves::braid_closure(4, std::array{1, -2, 3})}).knotted[0]);
}
