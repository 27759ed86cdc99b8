#include <catch2/catch.hpp>

#include "fixtures.hpp"

namespace tencer::sensitivity {
namespace {

double distance_between(const model::State& a, const model::State& b) {
  double largest = 0;
  for (std::size_t r = 0; r < a.size(); ++r)
    largest = std::max(largest, (a[r].x - b[r].x).colwise().norm().maxCoeff());
  return largest;
}

double& position_a(springs::Cable& cable) { return std::get<springs::OnRod>(cable.a).s; }

// A buckled rod between two hinges, bulging upwards, and a soft spring from its crown to an anchor
// below. Pulled far enough, it snaps through.
Example shallow_arch() {
  Example e{.name = "shallow arch"};
  constexpr int n = 41;
  e.start = {Eigen::Matrix3Xd::Zero(3, n)};
  for (int i = 0; i < n; ++i) {
    const double u = static_cast<double>(i) / (n - 1);
    // A little lopsided, for the arch to fail sideways like a real one.
    e.start[0].col(i) << u, 0.15 * std::sin(std::numbers::pi * u) + 1e-3 * std::sin(7 * u), 0;
  }
  e.start[0](1, n - 1) = 0;
  e.structure.rods = {rod_along(e.start[0], false, round_section(1e4))};
  e.structure.planar = true;
  e.structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = n - 1}};
  e.structure.anchors = Eigen::Vector3d(0.5, -3, 0);
  const double length = e.structure.rods[0].length();
  e.structure.cables = {anchored(0, 0, 0.49 * length, 20.0, 3.1)};
  e.target = model::make_target(e.structure, e.start);
  return e;
}

}  // namespace

TEST_CASE("a trial depends on the committed configuration and the cables alone") {
  for (const Example& e : examples()) {
    INFO(e.name);
    Tracker tracker = track(e);
    REQUIRE(tracker.first().usable());
    auto one = e.structure.cables;
    auto other = e.structure.cables;
    for (std::size_t c = 0; c < one.size(); ++c) {
      one[c].stiffness *= 1.1;
      other[c].stiffness *= 0.7;
      // To other edges, so that the pattern of the Hessian changes.
      if (auto* end = std::get_if<springs::OnRod>(&other[c].b)) end->s -= 0.4;
    }
    REQUIRE(tracker.evaluate(one).usable());
    const model::State before = tracker.trial().state;
    tracker.evaluate(other);
    REQUIRE(tracker.evaluate(one).usable());
    CHECK(distance_between(tracker.trial().state, before) == 0);
  }
}

TEST_CASE("trials leave the committed configuration alone until one is committed") {
  const Example e = two_rods();
  Tracker tracker = track(e);
  const model::State before = tracker.committed().state;
  auto cables = e.structure.cables;
  cables[2].rest_length += 0.01;
  const Trial trial = tracker.evaluate(cables);
  REQUIRE(trial.usable());
  CHECK(trial.motion > 1e-3);
  CHECK(distance_between(tracker.committed().state, before) == 0);
  CHECK(tracker.committed().cables()[2].rest_length == e.structure.cables[2].rest_length);
  const model::State after = tracker.trial().state;
  tracker.commit();
  CHECK(distance_between(tracker.committed().state, after) == 0);
  CHECK(tracker.committed().cables()[2].rest_length == cables[2].rest_length);
  CHECK_THROWS_AS(tracker.commit(), std::invalid_argument);
  // Back again, but for a rigid motion: nothing is lost on the way.
  REQUIRE(tracker.evaluate(e.structure.cables).usable());
  const model::Target there{.points = {before[0].x, before[1].x}};
  CHECK(deviation(there, tracker.trial().state).max < 1e-8);
}

TEST_CASE("predictions err in second order, also where attachments pass vertices") {
  Example e = closed_rod(1e3);
  const auto knots = [&](int vertex) {
    return geometry::ArcLength(e.structure.rods[0].rest_lengths, true).knots()[vertex];
  };
  position_a(e.structure.cables[0]) = knots(2);         // at a vertex
  position_a(e.structure.cables[1]) = knots(5) + 1e-7;  // next to one
  position_a(e.structure.cables[2]) = 0;                // at the seam
  Tracker tracker = track(e);
  for (const double direction : {1.0, -1.0})
    for (int c = 0; c < 3; ++c) {
      const auto evaluate = [&](double distance) {
        auto cables = e.structure.cables;
        position_a(cables[c]) += direction * distance;
        return tracker.evaluate(cables);
      };
      const Trial near = evaluate(1e-4);
      const Trial far = evaluate(1e-3);
      CHECK(near.usable());
      CHECK(far.usable());
      CHECK(far.motion == Approx(10 * near.motion).epsilon(1e-2));
      CHECK(near.correction < 2e-2 * far.correction);
    }
}

TEST_CASE("attachments go the short way round a closed rod") {
  Example e = closed_rod(1e3);
  const double length = e.structure.rods[0].length();
  position_a(e.structure.cables[0]) = 0.01;
  Tracker tracker = track(e);
  auto cables = e.structure.cables;
  position_a(cables[0]) = -0.01;
  REQUIRE(tracker.evaluate(cables).usable());
  const model::State there = tracker.trial().state;
  position_a(cables[0]) = length - 0.01;
  const Trial trial = tracker.evaluate(cables);
  REQUIRE(trial.usable());
  CHECK(trial.solves == 1);
  CHECK(distance_between(tracker.trial().state, there) < 1e-9);
}

TEST_CASE("rebased cables move nothing") {
  const Example e = closed_rod(1e3);
  Tracker tracker = track(e);
  const model::State before = tracker.committed().state;
  auto cables = e.structure.cables;
  for (std::size_t c = 0; c < cables.size(); ++c) {
    const auto span = model::span_of(tracker.committed().system.stencils()[c], before);
    cables[c].stiffness = 2 * e.structure.cables[c].stiffness;
    cables[c].rest_length = (span.norm() + cables[c].rest_length) / 2;
  }
  const Trial trial = tracker.evaluate(cables);
  CHECK(trial.usable());
  CHECK(trial.motion < 1e-12);
  CHECK(distance_between(tracker.trial().state, before) < 1e-10);
}

TEST_CASE("a snapping arch is a failed evaluation and changes nothing") {
  const Example e = shallow_arch();
  Tracker tracker = track(e);
  REQUIRE(tracker.first().usable());
  const auto crown = [](const Configuration& at) { return at.state[0].x(1, 20); };
  REQUIRE(crown(tracker.committed()) > 0.05);

  auto cables = e.structure.cables;
  Trial trial;
  int committed = 0;
  for (double rest_length = 3.08; rest_length > 1; rest_length -= 0.02) {
    cables[0].rest_length = rest_length;
    trial = tracker.evaluate(cables);
    if (!trial.usable()) break;
    tracker.commit();
    ++committed;
    REQUIRE(crown(tracker.committed()) > 0);
  }
  REQUIRE_FALSE(trial.usable());
  CHECK(committed > 0);
  CHECK((trial.outcome == Outcome::jumped || trial.outcome == Outcome::lost_balance));
  CHECK_THROWS_AS(tracker.commit(), std::invalid_argument);

  // There is an equilibrium to jump to: the other side.
  model::Structure pulled = e.structure;
  pulled.cables = cables;
  const auto below = equilibrium::solve(equilibrium::System(pulled), tracker.committed().state);
  REQUIRE(below.usable());
  CHECK(below.state[0].x(1, 20) < 0);

  // The committed configuration still answers, as if nothing had been tried.
  cables[0].rest_length += 0.019;
  REQUIRE(tracker.evaluate(cables).usable());
  CHECK(crown(tracker.trial()) > 0);
}

TEST_CASE("a change too large for one step is followed in parts") {
  const Example e = closed_rod(1e3);
  Tracker at_once = track(e, {.tolerance = 1e-13, .max_correction = 0.1, .smallest_step = 1});
  Tracker in_parts = track(e, {.tolerance = 1e-13, .max_correction = 0.1});
  Tracker by_hand = track(e);
  auto cables = e.structure.cables;
  cables[0].rest_length += 0.5;
  cables[3].rest_length += 0.3;
  CHECK(at_once.evaluate(cables).outcome == Outcome::jumped);
  const Trial trial = in_parts.evaluate(cables);
  REQUIRE(trial.usable());
  CHECK(trial.solves > 1);
  for (int k = 1; k <= 50; ++k) {
    auto part = e.structure.cables;
    part[0].rest_length += 0.5 * k / 50;
    part[3].rest_length += 0.3 * k / 50;
    REQUIRE(by_hand.evaluate(part).usable());
    by_hand.commit();
  }
  const model::Target there{.points = {by_hand.committed().state[0].x}};
  CHECK(deviation(there, in_parts.trial().state).max < 1e-9);
}

TEST_CASE("cables that are not the committed ones are refused") {
  const Example e = anchored_rod();
  Tracker tracker = track(e);
  auto fewer = e.structure.cables;
  fewer.pop_back();
  CHECK_THROWS_AS(tracker.evaluate(fewer), std::invalid_argument);
  auto other_anchor = e.structure.cables;
  other_anchor.back().a = springs::AtAnchor{0};
  CHECK_THROWS_AS(tracker.evaluate(other_anchor), std::invalid_argument);
  auto one_sided = e.structure.cables;
  one_sided[0].tension_only = true;
  CHECK_THROWS_AS(tracker.evaluate(one_sided), std::invalid_argument);
}

TEST_CASE("parameters are read from and written to cables") {
  const Example e = anchored_rod();
  const std::vector<springs::Parameter> parameters{{ParameterKind::stiffness, 1},
                                                   {ParameterKind::position_b, 3},
                                                   {ParameterKind::rest_length, 0},
                                                   {ParameterKind::position_a, 2}};
  const auto& cables = e.structure.cables;
  CHECK(values(cables, parameters) == Eigen::Vector4d(2.0, 0.31, 0.8, 2.05));
  const auto changed = with_values(cables, parameters, Eigen::Vector4d(1, 2, 3, 4));
  CHECK(values(changed, parameters) == Eigen::Vector4d(1, 2, 3, 4));
  const std::vector<springs::Parameter> anchored_end{{ParameterKind::position_a, 3}};
  CHECK_THROWS_AS(values(cables, anchored_end), std::invalid_argument);
  const std::vector<springs::Parameter> none{{ParameterKind::stiffness, 17}};
  CHECK_THROWS_AS(values(cables, none), std::invalid_argument);
}

}  // namespace tencer::sensitivity
