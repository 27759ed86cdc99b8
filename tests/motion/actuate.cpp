// Cables pulled and let go: what is known of arches, struts and rings.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/motion/actuate.hpp>

#include "fixtures/bow.hpp"

using namespace tencer;
using std::numbers::pi;

namespace {

constexpr int vertices = 41;

// Between hinges in the plane, bent up by `height`, about, a string from its middle down to an
// anchor that just does not pull.
struct Arch {
  fixtures::Held held{};
  double height = 0.0;
};

Arch arch_on_string(double height) {
  const double span = 1 - height * height * pi * pi / 4;
  model::Structure arch{.rods = {fixtures::slender_rod(vertices - 1, 1.0)},
                        .anchors = Eigen::Vector3d(span / 2, -2, 0),
                        .pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = vertices - 1}},
                        .planar = true};
  Eigen::Matrix3Xd x = fixtures::straight(vertices, span);
  for (int i = 0; i < vertices; ++i) x(1, i) = height * std::sin(pi * x(0, i) / span);
  Arch result{.held = fixtures::settled(arch, x)};
  result.height = result.held.state[0].x(1, vertices / 2);
  result.held.structure.cables = {
      {.a = springs::OnRod{0, 0.5}, .b = springs::AtAnchor{0}, .rest_length = 2 + result.height}};
  result.held.tensions = Eigen::VectorXd::Zero(1);
  return result;
}

Eigen::VectorXd length(double value) { return Eigen::VectorXd::Constant(1, value); }

}  // namespace

TEST_CASE("a shallow arch pulled down leans over, and snaps through where it is level") {
  const Arch arch = arch_on_string(0.04);
  const auto found = motion::actuate(arch.held.structure, arch.held.state, arch.held.tensions,
                                     {{.lengths = length(2 - 1.05 * arch.height), .frames = 20}});
  REQUIRE(found.finished);
  const int middle = vertices / 2;
  const auto before = [&](const motion::Jump& jump) {
    return found.frames[static_cast<std::size_t>(jump.before)];
  };
  const auto after = [&](const motion::Jump& jump) {
    return found.frames[static_cast<std::size_t>(jump.after)];
  };
  REQUIRE(found.jumps.size() == 2);
  // Where its thrust is Euler's second load the second mode begins, which costs no more thrust.
  const motion::Jump& leans = found.jumps[0];
  CHECK(leans.smooth);
  CHECK(leans.cause == motion::Cause::branching);
  CHECK(before(leans).state[0].x(1, middle) ==
        Approx(arch.height * pi / std::sqrt(12.0)).epsilon(0.005));
  // When it is that mode alone, its middle on the line between the hinges, the string goes slack:
  // the mode has four times the energy of the arch, pi^4 h^2 / 4.
  const motion::Jump& snaps = found.jumps[1];
  CHECK_FALSE(snaps.smooth);
  CHECK_FALSE(snaps.strands_met);
  CHECK(snaps.cause == motion::Cause::turning);
  CHECK(before(snaps).state[0].x(1, middle) == Approx(0).margin(1e-3 * arch.height));
  CHECK(after(snaps).state[0].x(1, middle) == Approx(-arch.height).epsilon(1e-4));
  CHECK(after(snaps).tensions[0] == 0);
  CHECK(snaps.released ==
        Approx(0.75 * std::pow(pi, 4) * arch.height * arch.height).epsilon(0.005));
  CHECK(found.frames.back().part == 1);
  CHECK(found.frames.back().state[0].x(1, middle) == Approx(-1.05 * arch.height).epsilon(1e-6));
}

TEST_CASE("pulled and let go again, a structure that does not jump comes back") {
  const auto bow = fixtures::bow();
  const Eigen::Vector2d lengths(bow.structure.cables[0].rest_length,
                                bow.structure.cables[1].rest_length);
  const auto found =
      motion::actuate(bow.structure, bow.state, bow.tensions,
                      {{.lengths = 0.9 * lengths, .frames = 4}, {.lengths = lengths, .frames = 4}});
  REQUIRE(found.finished);
  CHECK(found.jumps.empty());
  REQUIRE(found.frames.size() == 9);
  CHECK(found.frames.back().energy == Approx(found.frames.front().energy).epsilon(1e-9));
  CHECK((found.frames.back().tensions - bow.tensions).norm() < 1e-6 * bow.tensions.norm());
  for (const auto& frame : found.frames) CHECK(frame.lengths.size() == 2);
}

TEST_CASE("a ring leaves its plane without a jump") {
  constexpr int count = 60;
  model::Structure ring;
  ring.rods = {fixtures::slender_rod(count, 1.0)};
  ring.rods[0].closed = true;
  const double diameter = 1 / pi;
  ring.cables = {
      {.a = springs::OnRod{0, 0.0}, .b = springs::OnRod{0, 0.5}, .rest_length = 0.9 * diameter}};
  Eigen::Matrix3Xd x(3, count);
  for (int i = 0; i < count; ++i)
    x.col(i) << diameter / 2 * std::cos(2 * pi * i / count),
        diameter / 2 * std::sin(2 * pi * i / count), 0;
  const auto held = fixtures::settled(ring, x);
  const auto found = motion::actuate(held.structure, held.state, held.tensions,
                                     {{.lengths = length(0.2 * diameter), .frames = 14}});
  REQUIRE(found.finished);
  REQUIRE(found.jumps.size() == 1);
  CHECK(found.jumps[0].smooth);
  CHECK(found.jumps[0].cause == motion::Cause::branching);
  const motion::Frame& before = found.frames[static_cast<std::size_t>(found.jumps[0].before)];
  CHECK(before.lengths[0] / diameter == Approx(0.37).margin(0.01));
  CHECK(std::abs(found.jumps[0].released) < 1e-2 * before.energy);
  const auto height = [](const motion::Frame& frame) {
    const Eigen::Vector3d lowest = frame.state[0].x.rowwise().minCoeff();
    return (frame.state[0].x.rowwise().maxCoeff() - lowest)[2];
  };
  CHECK(height(before) < 1e-6);
  CHECK(height(found.frames.back()) > 0.05);
}
