#include <catch2/catch.hpp>
#include <tencer/equilibrium/stability.hpp>
#include <tencer/network/rest_length.hpp>

#include "fixtures/networks.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using namespace tencer::network;

namespace {

double eigenvalue(const Network& network) {
  return equilibrium::stability(equilibrium::System(network.structure), network.state)
      .smallest_eigenvalue;
}

// A ring drawn together across a diameter by a cable of this force density, in its plane (figure
// 8).
Network drawn_ring(double force_density) {
  const int vertices = 24;
  const Model model = make_model({curves::circle(1.0, vertices)});
  Network network{.structure = model.structure};
  network.structure.cables.push_back(
      {.a = springs::OnRod{0, 0.0}, .b = springs::OnRod{0, 0.5}, .stiffness = force_density});
  network.structure.planar = true;
  const auto flat = equilibrium::solve(equilibrium::System(network.structure),
                                       model::make_state(network.structure, model.positions));
  REQUIRE(flat.usable());
  network.structure.planar = false;
  network.state = flat.state;
  return network;
}

}  // namespace

TEST_CASE("Rebased springs pull the same in the same place") {
  const Model model = trefoil();
  const Network network = greedy_network(model);
  const Eigen::VectorXd tensions = cable_tensions(network);
  for (const double rest_ratio : {0.0, 0.5, 0.99}) {
    const Network other = rebased(network, rest_ratio);
    CHECK((cable_tensions(other) - tensions).norm() < 1e-12 * tensions.norm());
    CHECK((cable_lengths(other) - cable_lengths(network)).norm() == 0.0);
    for (int i = 0; i < cable_count(other); ++i)
      CHECK(other.structure.cables[i].rest_length ==
            Approx(rest_ratio * cable_lengths(network)[i]).margin(1e-15));
    CHECK(equilibrium::residual(equilibrium::System(other.structure), other.state) < 1e-8);
  }
}

TEST_CASE("The eigenvalue grows with the rest length, and the smallest stable one is found") {
  // Few cables, so that zero rest lengths are not stable.
  const Network network = greedy_network(trefoil(), 20.0);
  double last = -1e300;
  int smallest = -1;
  for (int percent = 0; percent <= 99; ++percent) {
    const double now = eigenvalue(rebased(network, percent / 100.0));
    CHECK(now >= last - 1e-6 * std::abs(last));
    last = now;
    if (smallest < 0 && now > 0) smallest = percent;
  }
  REQUIRE(smallest > 0);
  const auto found = smallest_stable_rest_length(network);
  REQUIRE(found.stable);
  CHECK(found.rest_ratio == Approx(smallest / 100.0));
  CHECK(found.smallest_eigenvalue ==
        Approx(eigenvalue(rebased(network, found.rest_ratio))).epsilon(1e-6));
}

TEST_CASE("A margin asks for stiffer springs") {
  const Model model = trefoil();
  const Network network = greedy_network(model);
  const double stiffest = eigenvalue(rebased(network, 0.99));
  CHECK(stiffest_eigenvalue(network) == Approx(stiffest));
  const auto found = smallest_stable_rest_length(network, {.margin = 0.5});
  REQUIRE(found.stable);
  REQUIRE(found.rest_ratio > 0);
  CHECK(found.smallest_eigenvalue >= 0.5 * stiffest);
  CHECK(eigenvalue(rebased(network, found.rest_ratio - 0.01)) < 0.5 * stiffest);
  const auto least = smallest_stable_rest_length(network, {.min_eigenvalue = 0.5 * stiffest});
  CHECK(least.rest_ratio == found.rest_ratio);
}

TEST_CASE("A state that no rest length makes stable is reported as such") {
  CHECK(smallest_stable_rest_length(drawn_ring(100.0)).stable);
  const auto buckles = smallest_stable_rest_length(drawn_ring(6400.0));
  CHECK_FALSE(buckles.stable);
  CHECK(buckles.smallest_eigenvalue < 0);
}

TEST_CASE("Rods that no cable ties together are not stable") {
  Network network = greedy_network(linked_ellipses());
  REQUIRE(smallest_stable_rest_length(network).stable);
  std::erase_if(network.structure.cables, [](const auto& cable) {
    return std::get<springs::OnRod>(cable.a).rod != std::get<springs::OnRod>(cable.b).rod;
  });
  REQUIRE(cable_count(network) > 0);
  CHECK_FALSE(smallest_stable_rest_length(network).stable);
}

TEST_CASE("Cables that push cannot be rebased") {
  Network network = drawn_ring(100.0);
  network.structure.cables[0].rest_length = 10.0;
  CHECK_THROWS_AS(rebased(network, 0.5), std::invalid_argument);
}
