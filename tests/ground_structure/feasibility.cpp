#include <catch2/catch.hpp>
#include <numbers>
#include <tencer/geometry/frame.hpp>
#include <tencer/ground_structure/feasibility.hpp>

#include "fixtures/problems.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using namespace tencer::ground_structure;

namespace {

// An open helix without anchors: cables between its own vertices cannot keep it from unwinding.
Model open_helix() {
  constexpr int vertices = 41;
  geometry::Polyline helix{.points = Eigen::Matrix3Xd(3, vertices), .closed = false};
  for (int i = 0; i < vertices; ++i) {
    const double angle = 6 * std::numbers::pi * i / (vertices - 1);
    helix.points.col(i) << std::cos(angle), std::sin(angle), angle / 5;
  }
  return make_model({helix});
}

struct Case {
  explicit Case(const Model& model)
      : problem(problem_of(model)),
        bare(problem.structure),
        candidates(candidate_orbits(bare, problem.start, problem.candidates, nullptr)),
        first(relaxation(bare, problem.start, candidates).value()) {}

  double length(std::size_t candidate, const model::State& state) const {
    return model::span_of(candidates[candidate].front().stencil, state).norm();
  }

  Problem problem;
  equilibrium::System bare;
  std::vector<CandidateOrbit> candidates;
  Relaxation first;
};

}  // namespace

TEST_CASE("a motion proves that no tensions balance: rods relax, no candidate is lengthened") {
  const Case helix(open_helix());
  REQUIRE(helix.first.largest > 1e-3);
  // Central differences along the motion, of quantities that know nothing of the dual.
  const double h = 1e-6 / helix.first.largest;
  const auto ahead = helix.bare.displaced(helix.problem.start, h * helix.first.motion);
  const auto behind = helix.bare.displaced(helix.problem.start, -h * helix.first.motion);
  const double power = (helix.bare.energy(ahead) - helix.bare.energy(behind)) / (2 * h);
  CHECK(power < 0);
  CHECK(-power == Approx(helix.first.power).epsilon(1e-4));
  double longest = -1;
  for (std::size_t c = 0; c < helix.candidates.size(); ++c)
    longest = std::max(longest, (helix.length(c, ahead) - helix.length(c, behind)) / (2 * h));
  CHECK(longest < 1e-6 * helix.first.largest);
  CHECK(helix.first.lengthening < 1e-8 * helix.first.largest);
}

TEST_CASE("tensions and motion are each other's dual") {
  for (const Model& model : {open_helix(), trefoil()}) {
    const Case given(model);
    const auto& tensions = given.first.tensions;
    REQUIRE(tensions.converged());
    CHECK(tensions.values.minCoeff() > 0);
    // A candidate that pulls keeps its length.
    for (const int c : tensions.set) {
      double rate = 0;
      for_each_unknown(given.bare, given.candidates[c].front(),
                       [&](int i, double weight) { rate += weight * given.first.motion[i]; });
      CHECK(std::abs(rate) < 1e-6 * given.first.largest + 1e-12);
    }
    // f^T v = v^T M v: what the motion gains is what is left of the forces.
    CHECK(given.first.power >= 0);
  }
}

TEST_CASE("rods that candidates hold rest at the target, others fall without lengthening any") {
  const Case held(trefoil());
  const TiedRest near = tied_rest(held.problem, held.candidates, held.first);
  CHECK(near.rests);
  CHECK(near.max_percent < 0.1);

  const Case helix(open_helix());
  const TiedRest far = tied_rest(helix.problem, helix.candidates, helix.first);
  CHECK(far.max_percent > 10);
  CHECK(far.proves_motion());
  CHECK(helix.bare.energy(far.state) < helix.bare.energy(helix.problem.start));
  for (std::size_t c = 0; c < helix.candidates.size(); ++c)
    CHECK(helix.length(c, far.state) <=
          (1 + TiedRest::allowed_lengthening) * helix.length(c, helix.problem.start));
}

TEST_CASE("a frame of anchors holds what cables between rods do not") {
  Model model = open_helix();
  const Eigen::Matrix3Xd& points = model.positions[0];
  model.structure.anchors = geometry::enclosing_frame(
      geometry::FrameShape::cube, points, 0.1 * points.colwise().norm().maxCoeff(), false);
  const Case hung(model);
  CHECK(tied_rest(hung.problem, hung.candidates, hung.first).max_percent < 0.1);
}

TEST_CASE("rods at rest need no tensions, and none are found where there are no candidates") {
  const Case straight(make_model({geometry::Polyline{
      .points = Eigen::RowVectorXd::LinSpaced(20, 0, 1).replicate(3, 1), .closed = false}}));
  CHECK(straight.first.largest < 1e-9);
  const auto alone = relaxation(straight.bare, straight.problem.start, {});
  REQUIRE(alone);
  CHECK(alone->tensions.set.empty());
}

TEST_CASE("rods that lie apart are drawn together by every cable between them") {
  auto rings = std::vector<geometry::Polyline>(2, curves::ellipse(1.3, 1, 24));
  rings[1].points.row(0).array() += 4;
  const Case apart(make_model(rings));
  const auto found = separation(apart.problem, apart.candidates);
  REQUIRE(found);
  CHECK(found->rods.size() == 1);
  const double h = 1e-6 / found->motion.norm();
  const auto ahead = apart.bare.displaced(apart.problem.start, h * found->motion);
  const auto behind = apart.bare.displaced(apart.problem.start, -h * found->motion);
  for (std::size_t c = 0; c < apart.candidates.size(); ++c) {
    const auto& cable = apart.candidates[c].front().cable;
    const bool between =
        std::get<springs::OnRod>(cable.a).rod != std::get<springs::OnRod>(cable.b).rod;
    const double rate = (apart.length(c, ahead) - apart.length(c, behind)) / (2 * h);
    if (between)
      CHECK(rate < -1e-9);
    else
      CHECK(std::abs(rate) < 1e-5);
  }
}

TEST_CASE("rods that are linked, or lie within each other, can be tied") {
  const Case linked(linked_ellipses());
  CHECK_FALSE(separation(linked.problem, linked.candidates));
  const Case nested(make_model({curves::ellipse(1.3, 1, 24), curves::ellipse(2.5, 2.2, 30)}));
  CHECK_FALSE(separation(nested.problem, nested.candidates));
  // Anchors about rods that lie apart hold each of them.
  auto rings = std::vector<geometry::Polyline>(2, curves::ellipse(1.3, 1, 24));
  rings[1].points.row(0).array() += 4;
  Model model = make_model(rings);
  Eigen::Matrix3Xd points(3, 48);
  points << model.positions[0], model.positions[1];
  model.structure.anchors =
      geometry::enclosing_frame(geometry::FrameShape::cube, points, 0.05, false);
  const Case hung(model);
  CHECK_FALSE(separation(hung.problem, hung.candidates));
}

TEST_CASE("options of letting go are checked") {
  CHECK_THROWS_WITH((TiedRestOptions{.near_percent = -1}.validate()), Catch::Contains("near"));
  CHECK_THROWS_WITH((TiedRestOptions{.max_iterations = 0}.validate()), Catch::Contains("max"));
}
