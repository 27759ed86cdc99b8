#include <catch2/catch.hpp>
#include <tencer/equilibrium/balancing.hpp>
#include <tencer/equilibrium/path.hpp>

#include "fixtures/bow.hpp"
#include "models.hpp"

using namespace tencer;
using namespace tencer::equilibrium;
using fixtures::Held;
using fixtures::settled;

namespace {

// A planar ring squeezed by two cables side by side, across it at vertices 0 and 2.
Held squeezed_ring() {
  model::Structure ring = models::ring_with_cable(40, 0.0, 0.28);
  ring.planar = true;
  ring.cables.push_back(
      {.a = springs::OnRod{0, 0.05}, .b = springs::OnRod{0, 0.45}, .rest_length = 0.27});
  return settled(std::move(ring), models::polygon(40, 1.0));
}

// Largest difference of the distances between vertices: rigid motion does not count.
double distance(const model::State& a, const model::State& b) {
  double largest = 0;
  for (Eigen::Index i = 0; i < a[0].x.cols(); ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      largest = std::max(largest, std::abs((a[0].x.col(i) - a[0].x.col(j)).norm() -
                                           (b[0].x.col(i) - b[0].x.col(j)).norm()));
  return largest;
}

// A rod between hinges nearer to each other than it is long, bent upwards, its middle on a string
// that hangs from it down to an anchor.
Held arch_on_string() {
  const int n = 31;
  const double span = 0.995;
  model::Structure arch{.rods = {models::slender_rod(false, n, 1.0, 1e3)},
                        .anchors = Eigen::Vector3d(span / 2, -2, 0),
                        .pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = n - 1}},
                        .planar = true};
  Eigen::Matrix3Xd x = models::straight(n, span);
  for (int i = 0; i < n; ++i) x(1, i) = 0.045 * std::sin(std::numbers::pi * x(0, i) / span);
  const Equilibrium free = solve(System(arch), model::make_state(arch, {x}));
  REQUIRE(free.usable());
  arch.cables = {{.a = springs::OnRod{0, 0.5},
                  .b = springs::AtAnchor{0},
                  .rest_length = 2 + free.state[0].x(1, n / 2)}};
  return {arch, free.state, Eigen::VectorXd::Zero(1)};
}

}  // namespace

TEST_CASE("a path leads where relaxation does when there is one rest only") {
  const Held start = squeezed_ring();
  model::Structure other = start.structure;
  other.cables[0].rest_length = 0.26;
  other.cables[1].rest_length = 0.262;
  const PathEquilibrium path = settle_along(other, start.state, start.tensions);
  REQUIRE(path.followed());
  const InextensibleEquilibrium relaxed = relax_inextensible(other, start.state);
  REQUIRE(relaxed.equilibrium.usable());
  CHECK(distance(path.rest.equilibrium.state, relaxed.equilibrium.state) < 1e-8);
  CHECK((path.rest.tensions - relaxed.tensions).norm() < 1e-5 * relaxed.tensions.norm());
  CHECK(path.rest.stretch < 1e-10);
  CHECK(assess(other, path.rest.equilibrium.state, path.rest.tensions).residual < 1e-6);
}

TEST_CASE("a small change of lengths takes one step and one factorisation") {
  const Held standing = squeezed_ring();
  const PathStart start(standing.structure, standing.state, standing.tensions);
  CHECK(start.lengths()[0] == Approx(0.28));
  double moved[2];
  for (const int half : {0, 1}) {
    const Eigen::VectorXd lengths = start.lengths() * (1 - (half ? 0.5e-5 : 1e-5));
    const PathEquilibrium path = settle_along(start, lengths);
    REQUIRE(path.followed());
    CHECK(path.steps == 1);
    CHECK(path.rest.equilibrium.factorisations == 1);
    moved[half] = distance(path.rest.equilibrium.state, standing.state);
  }
  CHECK(moved[0] == Approx(2 * moved[1]).epsilon(1e-3));
}

TEST_CASE("cables go slack and taut on the way") {
  const Held start = squeezed_ring();
  REQUIRE(start.tensions.minCoeff() > 0);
  model::Structure loose = start.structure;
  loose.cables[1].rest_length = 0.3;
  const PathEquilibrium there = settle_along(loose, start.state, start.tensions);
  REQUIRE(there.followed());
  CHECK(there.rest.tensions[0] > 0);
  CHECK(there.rest.tensions[1] == 0);
  const PathEquilibrium back =
      settle_along(start.structure, there.rest.equilibrium.state, there.rest.tensions);
  REQUIRE(back.followed());
  CHECK(distance(back.rest.equilibrium.state, start.state) < 1e-8);
  CHECK((back.rest.tensions - start.tensions).norm() < 1e-5 * start.tensions.norm());
}

TEST_CASE("forces that the start lacks fade along the way") {
  const Held standing = squeezed_ring();
  // Of what balances the ring a tenth is missing.
  const PathEquilibrium path =
      settle_along(standing.structure, standing.state, 0.9 * standing.tensions);
  REQUIRE(path.followed());
  CHECK(path.rest.equilibrium.factorisations <= 10);
  const auto found = assess(standing.structure, path.rest.equilibrium.state, path.rest.tensions);
  CHECK(found.residual < 1e-6);
  CHECK((path.rest.tensions - standing.tensions).norm() < 1e-5 * standing.tensions.norm());
}

TEST_CASE("an arch pulled down follows its string, and leaves it where it snaps through") {
  const Held start = arch_on_string();
  const double height = start.structure.cables[0].rest_length - 2;
  const auto pulled_to = [&](double share) {
    model::Structure arch = start.structure;
    arch.cables[0].rest_length = 2 + share * height;
    return settle_along(arch, start.state, start.tensions);
  };
  const PathEquilibrium held = pulled_to(0.95);
  REQUIRE(held.followed());
  CHECK(held.rest.equilibrium.state[0].x(1, 15) == Approx(0.95 * height));
  CHECK(held.rest.tensions[0] > 0);

  // A shallow arch of sine shape gives way to its second mode where its thrust is that of Euler's
  // second load: pulled down to pi / (2 sqrt 3) of its height. The string cannot push it back, and
  // below the line between the hinges nothing holds the arch but its mirror image.
  const double share = std::numbers::pi / std::sqrt(12.0);
  const PathEquilibrium snapped = pulled_to(-0.5);
  CHECK(snapped.held);
  REQUIRE(snapped.fold_at);
  CHECK(1 - 1.5 * *snapped.fold_at == Approx(share).epsilon(0.005));
  CHECK_FALSE(snapped.followed());
  REQUIRE(snapped.rest.equilibrium.usable());
  CHECK(snapped.rest.tensions[0] == 0);
  CHECK(snapped.rest.equilibrium.state[0].x(1, 15) == Approx(-height).epsilon(1e-6));
}

TEST_CASE("a pose that is not stable has no path") {
  const int n = 21;
  model::Structure strut{
      .rods = {models::slender_rod(false, n, 1.0, 300)},
      .cables = {{.a = springs::OnRod{0, 0.0}, .b = springs::OnRod{0, 1.0}, .rest_length = 0.9}}};
  Eigen::Matrix3Xd x = models::straight(n, 0.999);
  const PathEquilibrium path = settle_along(strut, model::make_state(strut, {x}));
  CHECK_FALSE(path.held);
  CHECK_FALSE(path.followed());
  REQUIRE(path.rest.equilibrium.usable());
  CHECK((path.rest.equilibrium.state[0].x.col(n - 1) - path.rest.equilibrium.state[0].x.col(0))
            .norm() == Approx(0.9));
}

TEST_CASE("tensions that balance a standing structure are found from its pose") {
  const Held start = squeezed_ring();
  const Eigen::VectorXd found = balancing_tensions(start.structure, start.state);
  CHECK((found - start.tensions).norm() < 1e-4 * start.tensions.norm());
}

TEST_CASE("cables side by side share the tension of one") {
  model::Structure ring = models::ring_with_cable(40, 0.0, 0.28);
  ring.planar = true;
  const Held start = settled(ring, models::polygon(40, 1.0));
  ring.cables.push_back(ring.cables[0]);
  const Eigen::VectorXd found = balancing_tensions(ring, start.state);
  CHECK(found[0] == Approx(start.tensions[0] / 2).epsilon(1e-4));
  CHECK(found[1] == Approx(found[0]).epsilon(1e-6));
}

TEST_CASE("path options out of range are refused") {
  const Held standing = squeezed_ring();
  const PathStart start(standing.structure, standing.state, standing.tensions);
  for (const PathOptions& options : {PathOptions{.max_step = 0}, PathOptions{.max_departure = 0},
                                     PathOptions{.min_step = 0}, PathOptions{.min_step = 2}})
    CHECK_THROWS_AS(settle_along(start, start.lengths(), options), std::invalid_argument);
  CHECK_THROWS_AS(settle_along(start, Eigen::VectorXd::Ones(1)), std::invalid_argument);
  CHECK_THROWS_AS(settle_along(start, Eigen::VectorXd::Zero(2)), std::invalid_argument);
}
