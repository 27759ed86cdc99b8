// Structures with errors: near the pose as to first order, and falling where their path turns.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/certify/draws.hpp>
#include <tencer/equilibrium/path.hpp>

#include "fixtures/bow.hpp"

using namespace tencer;
using Catch::Matchers::WithinRel;

namespace {

// An arch between two pins, in the plane, its middle drawn down by a cable: a little further and it
// snaps through.
fixtures::Held drawn_arch() {
  constexpr int vertices = 41;
  model::Structure arch;
  arch.planar = true;
  arch.rods = {fixtures::slender_rod(vertices - 1, 1.0)};
  arch.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = vertices - 1}};
  const Eigen::Matrix3Xd x = fixtures::elastica(vertices, 0.6).x;
  const Eigen::Vector3d top = x.col(vertices / 2);
  arch.anchors = Eigen::Vector3d(top[0] + 0.05, top[1] - 1, 0);
  arch.cables = {{.a = springs::AtAnchor{0}, .b = springs::OnRod{0, 0.513}, .rest_length = 0.95}};
  auto found = equilibrium::settle_along(arch, model::make_state(arch, {x}));
  return {std::move(arch), std::move(found.rest.equilibrium.state), std::move(found.rest.tensions)};
}

}  // namespace

TEST_CASE("small errors move a bow as to first order") {
  const auto bow = fixtures::bow();
  const certify::CableErrors errors{.length = 1e-5, .attachment = 1e-5};
  const auto response = certify::pose_response(bow.structure, bow.state, bow.tensions);
  const auto draws = certify::settle_draws(bow.structure, bow.state, bow.tensions, errors, 5, 3);
  REQUIRE(draws.size() == 5);
  const Eigen::MatrixXd units = certify::unit_draws(6, 5, 3);
  for (int draw = 0; draw < 5; ++draw) {
    CHECK(draws[draw].rests);
    CHECK_FALSE(draws[draw].falls_at);
    const Eigen::VectorXd moved = 1e-5 * (response.displacement * units.col(draw));
    CHECK_THAT(draws[draw].deviation,
               WithinRel(moved.reshaped(3, moved.size() / 3).colwise().norm().maxCoeff(), 0.01));
  }
  const auto fall =
      certify::first_fall(bow.structure, bow.state, bow.tensions, errors, draws, 3, 4);
  CHECK_FALSE(fall.times);
  CHECK(fall.looked_to == 4);
}

TEST_CASE("an arch falls with the error at which its path turns") {
  const auto arch = drawn_arch();
  REQUIRE(arch.tensions[0] > 0);
  // Drawn down far enough it has snapped through on the way.
  const equilibrium::PathStart start(arch.structure, arch.state, arch.tensions);
  const auto far = equilibrium::settle_along(start, start.lengths().array() - 0.3);
  REQUIRE(far.fold_at);
  const double turns = 0.3 * *far.fold_at;

  constexpr int draws = 8;
  constexpr double error = 0.02;
  const Eigen::MatrixXd units = certify::unit_draws(1 + 1, draws, 1);
  const double shortest = -units.row(0).minCoeff();
  REQUIRE(shortest > 0.5);
  const certify::CableErrors errors{.length = error};
  const auto once =
      certify::settle_draws(arch.structure, arch.state, arch.tensions, errors, draws, 1);
  const auto first =
      certify::first_fall(arch.structure, arch.state, arch.tensions, errors, once, 1, 64);
  REQUIRE(first.times);
  CHECK_THAT(*first.times, WithinRel(turns / (error * shortest), 0.02));

  const certify::CableErrors more{.length = 1.05 * *first.times * error};
  int fallen = 0;
  for (const auto& draw :
       certify::settle_draws(arch.structure, arch.state, arch.tensions, more, draws, 1))
    fallen += draw.falls_at ? 1 : 0;
  CHECK(fallen >= 1);
  CHECK(fallen < draws);

  for (const double times : {1.0, 0.9 * *first.times, 1.05 * *first.times}) {
    const certify::CableErrors larger{.length = times * error};
    const auto settled =
        certify::settle_draws(arch.structure, arch.state, arch.tensions, larger, draws, 1);
    CHECK(certify::all_keep_their_paths(arch.structure, arch.state, arch.tensions, larger, draws,
                                        1) ==
          std::ranges::all_of(settled, &certify::Draw::keeps_its_path));
  }
}
