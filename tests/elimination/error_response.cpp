// The motion by errors along soft modes, against the response of all unknowns.
#include "model/error_response.hpp"

#include <catch2/catch.hpp>
#include <tencer/sensitivity/derivatives.hpp>

#include "fixtures/networks.hpp"
#include "model/local_model.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using namespace tencer::elimination;

TEST_CASE("Errors move a network along its soft modes as the full response does") {
  const Model model = trefoil(40);
  const network::Network network = greedy_network(model, 10.0);
  sensitivity::Configuration at{.system = equilibrium::System(network.structure)};
  at.linearisation.matrix = at.system.pattern();
  at.state =
      equilibrium::solve(at.system, network.state, {.tolerance = 1e-13}, at.linearisation).state;
  auto soft = equilibrium::soft_modes(at.system, at.linearisation, {});
  for (int round = 0; round < 20; ++round)
    soft = equilibrium::soft_modes(at.system, at.linearisation, soft);
  const Workmanship workmanship{.length_error = 2e-4, .attachment_error = 5e-4};
  const ErrorResponse response =
      error_response(at, soft, workmanship, 0, Eigen::Matrix3d::Identity());

  const auto parameters = cable_parameters(at.cables(), 0);
  const Eigen::MatrixXd motion = sensitivity::state_derivatives(at, parameters);
  const Eigen::VectorXd mass = equilibrium::lumped_mass(at.system);
  for (Eigen::Index k = 0; k < 3; ++k) {
    double variance = 0;
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      const double limit = parameters[p].kind == springs::ParameterKind::rest_length ? 2e-4 : 5e-4;
      const double along =
          soft.modes.col(k).dot(mass.cwiseProduct(motion.col(static_cast<Eigen::Index>(p))));
      variance += limit * limit / 3 * along * along;
    }
    CHECK(response.covariance(k, k) == Approx(variance).epsilon(1e-3));
  }
  // The vertex that moves most moves more than the mean, and the softest modes have most of it.
  CHECK(response.deviation > std::sqrt(response.covariance.trace()));
  double largest = 0;
  for (int v = 0; v < at.state[0].x.cols(); ++v) {
    double variance = 0;
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      const double limit = parameters[p].kind == springs::ParameterKind::rest_length ? 2e-4 : 5e-4;
      for (int axis = 0; axis < 3; ++axis)
        variance +=
            limit * limit / 3 *
            std::pow(motion(at.system.position_index(0, v, axis), static_cast<Eigen::Index>(p)), 2);
    }
    largest = std::max(largest, variance);
  }
  CHECK(response.deviation < 1.05 * std::sqrt(largest));
  CHECK(response.deviation > 0.5 * std::sqrt(largest));
}

TEST_CASE("Without errors nothing moves") {
  const Model model = trefoil(40);
  const network::Network network = greedy_network(model, 10.0);
  sensitivity::Configuration at{.system = equilibrium::System(network.structure),
                                .state = network.state};
  at.linearisation.matrix = at.system.pattern();
  equilibrium::linearise(at.system, at.state, at.linearisation);
  const auto soft = equilibrium::soft_modes(at.system, at.linearisation, {});
  CHECK(error_response(at, soft, {}, 0, Eigen::Matrix3d::Identity()).deviation == 0);
}
