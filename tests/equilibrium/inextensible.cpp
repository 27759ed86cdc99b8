#include <catch2/catch.hpp>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/springs/law.hpp>

#include "models.hpp"

using namespace tencer;
using namespace tencer::equilibrium;

TEST_CASE("inextensible cables of the equilibrium's lengths reproduce it") {
  const model::Structure ring = models::ring_with_cable(40, 60.0, 0.05);
  const System system(ring);
  model::State start = model::make_state(ring, {models::polygon(40, 1.0)});
  system.displace(start, 0.01 * Eigen::VectorXd::Random(system.size()));
  const Equilibrium sprung = solve(system, start);
  REQUIRE(sprung.usable());
  const double length = model::span_of(system.stencils()[0], sprung.state).norm();
  const double tension = springs::tension(ring.cables[0], length);

  model::Structure built = ring;
  built.cables[0].rest_length = length;
  const InextensibleEquilibrium form =
      relax_inextensible(built, model::make_state(ring, {sprung.state[0].x}));
  REQUIRE(form.equilibrium.usable());
  CHECK(form.stretch < 1e-10);
  CHECK(form.tensions[0] == Approx(tension).epsilon(1e-6));
  CHECK(form.equilibrium.energy > 0);
}

TEST_CASE("a cable longer than the structure needs is slack and reported") {
  const model::Structure ring = models::ring_with_cable(40, 1.0, 0.4);
  const InextensibleEquilibrium form =
      relax_inextensible(ring, model::make_state(ring, {models::polygon(40, 1.0)}));
  REQUIRE(form.equilibrium.usable());
  CHECK(form.tensions[0] == 0);
  const Assessment assessment = assess(ring, form.equilibrium.state, form.tensions);
  CHECK(assessment.slack == std::vector<int>{0});
  CHECK_FALSE(assessment.certified());
}

TEST_CASE("a cable that pushes is not certified") {
  const model::Structure ring = models::ring_with_cable(40, 1.0, 0.3);
  const model::State state = model::make_state(ring, {models::polygon(40, 1.0)});
  const Assessment assessment = assess(ring, state, Eigen::VectorXd::Constant(1, -2.0));
  CHECK(assessment.slack == std::vector<int>{0});
  CHECK(assessment.tensions[0] == 0);
}

TEST_CASE("a cable for whose tension no spring is stiff enough does not settle") {
  model::Structure ring = models::ring_with_cable(40, 1.0, 1e-12);
  const model::State start = model::make_state(ring, {models::polygon(40, 1.0)});
  const InextensibleEquilibrium form =
      relax_inextensible(ring, start, Eigen::VectorXd::Constant(1, 1e10));
  CHECK_FALSE(form.equilibrium.usable());
  CHECK(form.equilibrium.state[0].x == start[0].x);
  CHECK_THROWS_AS(relax_inextensible(ring, start, Eigen::VectorXd::Constant(1, -1.0)),
                  std::invalid_argument);
}
