// Structures that come back, and one that has another pose to go to.
#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/certify/shoves.hpp>

#include "fixtures/bow.hpp"

using namespace tencer;

TEST_CASE("a bow comes back from small pushes, smooth and rough") {
  const auto bow = fixtures::bow();
  const auto modes =
      certify::vibration_modes(bow.structure, bow.state, bow.tensions, Eigen::VectorXd::Ones(1));
  for (const int count : {3, 10})
    for (const std::uint64_t seed : {1, 2, 3}) {
      const certify::Push push{.size = 0.02, .modes = count, .seed = seed};
      const auto rest = certify::push_and_release(bow.structure, bow.state, modes, push);
      CHECK(rest.rests);
      CHECK(rest.deviation < 1e-6);
      CHECK(std::abs(rest.energy) < 1e-6);
      CHECK_FALSE(rest.strands_met);
      const auto way = certify::way_of(bow.structure, bow.state, modes, push);
      REQUIRE(way.size() > 2);
      const auto away = [&](const std::vector<Eigen::Matrix3Xd>& at) {
        return (at[0] - bow.state[0].x).colwise().norm().maxCoeff();
      };
      CHECK(away(way.front()) > 0.5 * push.size);  // less what the alignment takes up
      CHECK(away(way.back()) < 1e-6);
      const auto again = certify::push_and_release(bow.structure, bow.state, modes, push);
      CHECK(again.state[0].x == rest.state[0].x);
    }
}

TEST_CASE(
    "pushed through the line of its pins an arch snaps to its mirror image, as high in energy") {
  // An arch between two pins, in the plane; the other side is as good.
  constexpr int vertices = 31;
  model::Structure arch;
  arch.planar = true;
  arch.rods = {fixtures::slender_rod(vertices - 1, 1.0)};
  arch.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = vertices - 1}};
  auto found = equilibrium::relax_inextensible(
      arch, model::make_state(arch, {fixtures::elastica(vertices, 0.6).x}));
  REQUIRE(found.equilibrium.usable());
  const auto& state = found.equilibrium.state;
  auto modes = certify::vibration_modes(arch, state, Eigen::VectorXd(0), Eigen::VectorXd::Ones(1));
  // A push straight through to the other side, in the shape that it has.
  modes.shapes = {{state[0].x}};
  modes.shapes[0][0].row(0).setZero();
  modes.shapes[0][0].col(0).setZero();
  modes.shapes[0][0].col(vertices - 1).setZero();
  modes.shapes[0][0] /= modes.shapes[0][0].cwiseAbs().maxCoeff();
  const double height = state[0].x.row(1).cwiseAbs().maxCoeff();
  bool went = false;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const auto rest = certify::push_and_release(arch, state, modes,
                                                {.size = 2 * height, .modes = 1, .seed = seed});
    CHECK(rest.rests);
    if (rest.deviation < 0.5 * height) continue;
    went = true;
    CHECK(rest.deviation == Approx(2 * height).epsilon(1e-3));
    CHECK(std::abs(rest.energy) < 1e-5);
  }
  CHECK(went);
}

TEST_CASE("strands that cross on the way are told") {
  // Two parallel rods, the upper one pushed through the lower one.
  constexpr int vertices = 21;
  model::Structure pair;
  pair.rods = {fixtures::slender_rod(vertices - 1, 1.0), fixtures::slender_rod(vertices - 1, 1.0)};
  Eigen::Matrix3Xd above = fixtures::straight(vertices, 1.0);
  above.row(2).array() += 0.05;
  const auto state = model::make_state(pair, {fixtures::straight(vertices, 1.0), above});
  certify::VibrationModes modes{.hertz = Eigen::VectorXd::Ones(1), .computed = true};
  Eigen::Matrix3Xd down = Eigen::Matrix3Xd::Zero(3, vertices);
  down.row(2).setOnes();
  modes.shapes = {{Eigen::Matrix3Xd::Zero(3, vertices), down}};
  int met = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4})
    met += certify::push_and_release(pair, state, modes, {.size = 0.2, .modes = 1, .seed = seed})
                   .strands_met
               ? 1
               : 0;
  // Up or down, as drawn.
  CHECK(met > 0);
  CHECK(met < 4);
}
