#include <catch2/catch.hpp>
#include <tencer/equilibrium/built.hpp>
#include <tencer/springs/law.hpp>

#include "models.hpp"

using namespace tencer;
using namespace tencer::equilibrium;

TEST_CASE("inextensible cables of the equilibrium's lengths reproduce it") {
  const Structure ring = models::ring_with_cable(40, 60.0, 0.05);
  const System system(ring);
  State start = make_state(ring, {models::polygon(40, 1.0)});
  system.displace(start, 0.01 * Eigen::VectorXd::Random(system.size()));
  const Equilibrium sprung = solve(system, start);
  REQUIRE(sprung.usable());
  const double length = span_of(system.stencils()[0], sprung.state).norm();
  const double tension = springs::tension(ring.cables[0], length);

  Structure built = ring;
  built.cables[0].rest_length = length;
  const BuiltForm form = settle(built, make_state(ring, {sprung.state[0].x}));
  REQUIRE(form.equilibrium.usable());
  CHECK(form.stretch < 1e-10);
  CHECK(form.tensions[0] == Approx(tension).epsilon(1e-6));
  CHECK(form.equilibrium.energy > 0);
}

TEST_CASE("a cable longer than the structure needs is slack and reported") {
  const Structure ring = models::ring_with_cable(40, 1.0, 0.4);
  const BuiltForm form = settle(ring, make_state(ring, {models::polygon(40, 1.0)}));
  REQUIRE(form.equilibrium.usable());
  CHECK(form.tensions[0] == 0);
  const Certificate certificate = certify(ring, form.equilibrium.state, form.tensions);
  CHECK(certificate.slack == std::vector<int>{0});
  CHECK_FALSE(certificate.stands());
}

TEST_CASE("a cable that pushes is not certified") {
  const Structure ring = models::ring_with_cable(40, 1.0, 0.3);
  const State state = make_state(ring, {models::polygon(40, 1.0)});
  const Certificate certificate = certify(ring, state, Eigen::VectorXd::Constant(1, -2.0));
  CHECK(certificate.slack == std::vector<int>{0});
  CHECK(certificate.tensions[0] == 0);
}
