#include <catch2/catch.hpp>
#include <numbers>
#include <tencer/ground_structure/dense_springs.hpp>

#include "fixtures/problems.hpp"

using namespace tencer;
using namespace tencer::fixtures;

TEST_CASE("Dense springs hold the target, at the paper's stiffness") {
  const Model model = trefoil();
  const network::Network network = dense_network(model);
  // 100 E c^2 / L with E = EA^2 / (4 pi EI) and c the diameter, c^2 = 16 EI / EA.
  const auto& rod = model.structure.rods[0];
  const double modulus = rod.section.EA * rod.section.EA / (4 * std::numbers::pi * rod.section.EI1);
  const double stiffness = 100 * modulus * 16 * rod.section.EI1 / rod.section.EA / rod.length();
  for (const auto& cable : network.structure.cables)
    CHECK(cable.stiffness == Approx(stiffness).epsilon(1e-12));
  CHECK(cable_tensions(network).cwiseAbs().maxCoeff() == 0.0);
}
