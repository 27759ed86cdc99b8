// First derivatives that steps are planned with, against differences.
#include "model/local_model.hpp"

#include <catch2/catch.hpp>

#include "fixtures/networks.hpp"
#include "model/soft_rates.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using namespace tencer::elimination;
using equilibrium::SoftModes;
using network::Network;

namespace {

struct At {
  sensitivity::Configuration configuration;
  Eigen::VectorXd density{}, length{};
  SoftModes soft{};
};

At solved(const Network& network, const SoftModes& nearby) {
  At at{.configuration = {.system = equilibrium::System(network.structure)}};
  auto& c = at.configuration;
  c.linearisation.matrix = c.system.pattern();
  c.state =
      equilibrium::solve(c.system, network.state, {.tolerance = 1e-13}, c.linearisation).state;
  const Network there{network.structure, c.state};
  at.length = cable_lengths(there);
  at.density = cable_tensions(there).cwiseQuotient(at.length);
  at.soft = equilibrium::soft_modes(c.system, c.linearisation, nearby);
  for (int round = 0; round < 20; ++round)
    at.soft = equilibrium::soft_modes(c.system, c.linearisation, at.soft);
  return at;
}

}  // namespace

TEST_CASE("Rates of lengths, force densities and soft eigenvalues are those of differences") {
  const Model model = trefoil(40);
  Network network = greedy_network(model, 10.0);
  const auto target = target_of(model, network);
  // Away from vertices, where rates jump.
  for (auto& cable : network.structure.cables) {
    std::get<springs::OnRod>(cable.a).s += 0.4 / 40;
    std::get<springs::OnRod>(cable.b).s += 0.3 / 40;
  }
  const At at = solved(network, {});
  network.state = at.configuration.state;
  const LocalModel local = local_model(at.configuration, target, nullptr);
  CHECK((local.length - at.length).norm() < 1e-12 * at.length.norm());
  CHECK((local.density - at.density).norm() < 1e-9 * at.density.norm());

  const Eigen::VectorXd lowest = soft_rates(at.configuration, at.soft, 0, local);
  for (const Eigen::Index z : {0, 1, 5, 12}) {
    const double step = 1e-5;
    const auto moved = [&](double by) {
      Network other = network;
      auto values = sensitivity::values(network.structure.cables, local.parameters);
      values[z] += by;
      other.structure.cables =
          sensitivity::with_values(network.structure.cables, local.parameters, values);
      return solved(other, at.soft);
    };
    const At up = moved(step);
    const At down = moved(-step);
    const Eigen::VectorXd density = (up.density - down.density) / (2 * step);
    const Eigen::VectorXd length = (up.length - down.length) / (2 * step);
    CHECK((local.density_rates.col(z) - density).norm() < 1e-5 * density.norm());
    CHECK((local.length_rates.col(z) - length).norm() < 1e-5 * length.norm());
    const double eigenvalue = (up.soft.values[0] - down.soft.values[0]) / (2 * step);
    CHECK(lowest[z] ==
          Approx(eigenvalue).epsilon(1e-4).margin(1e-4 * lowest.cwiseAbs().maxCoeff()));
  }
}

TEST_CASE("Fixed cables are no variables, and leave the rates of others as they are") {
  const Model model = trefoil(40);
  const Network network = greedy_network(model, 10.0);
  const auto target = target_of(model, network);
  sensitivity::Configuration at{.system = equilibrium::System(network.structure)};
  at.linearisation.matrix = at.system.pattern();
  at.state = equilibrium::solve(at.system, network.state, {}, at.linearisation).state;
  const LocalModel all = local_model(at, target, nullptr);
  const LocalModel some = local_model(at, target, nullptr, 2);
  REQUIRE(some.orbits.size() == all.orbits.size() - 2);
  CHECK(some.orbits.front() == std::vector<int>{2});
  const Eigen::Index variables = some.ties.cols();
  CHECK(variables == all.ties.cols() - 6);
  CHECK(some.motion.isApprox(all.motion.rightCols(variables)));
  CHECK(some.density.isApprox(all.density.tail(some.density.size())));
  CHECK(some.density_rates.isApprox(
      all.density_rates.bottomRightCorner(some.density.size(), variables)));
}
