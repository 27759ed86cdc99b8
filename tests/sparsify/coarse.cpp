#include "../../modules/sparsify/src/coarse.hpp"

#include <catch2/catch.hpp>
#include <tencer/sparsify/balance.hpp>

#include "models.hpp"

using namespace tencer;
using namespace tencer::sparsify;
using namespace tencer::sparsify::test;

TEST_CASE("Rods that have hardly more vertices than they need stay as they are") {
  const Model model = trefoil(60);
  CHECK_FALSE(coarsened(model.structure, {.points = model.positions}, {}).has_value());
}

TEST_CASE("The rods of another resolution lie where those were, and there and back is nearby") {
  const Model model = trefoil(144);
  const sensitivity::Target target{.points = model.positions};
  const auto problem = coarsened(model.structure, target, {});
  REQUIRE(problem);
  const int edges = problem->structure.rods[0].edges();
  CHECK(edges < 100);
  CHECK(edges % 12 == 0);
  // A chord is shorter than its arc.
  CHECK(problem->structure.rods[0].length() < model.structure.rods[0].length());
  CHECK(problem->structure.rods[0].length() > 0.99 * model.structure.rods[0].length());

  const Network bare{model.structure, equilibrium::make_state(model.structure, model.positions)};
  const Network fewer = carried(bare, problem->structure);
  CHECK((fewer.state[0].x - problem->target.points[0]).cwiseAbs().maxCoeff() < 1e-12);
  const Network back = carried(fewer, model.structure);
  const double size = model.positions[0].rowwise().norm().maxCoeff();
  CHECK((back.state[0].x - model.positions[0]).colwise().norm().maxCoeff() < 2e-4 * size);
}

TEST_CASE("A network carried to another resolution settles nearby, its ends in the same places") {
  const Model model = trefoil(144);
  const sensitivity::Target target{.points = model.positions};
  const auto problem = coarsened(model.structure, target, {});
  REQUIRE(problem);
  const Network bare{problem->structure,
                     equilibrium::make_state(problem->structure, problem->target.points)};
  const Network coarse =
      balance(bare, problem->target, problem->candidates, nullptr, {.percent = 0.5}).network;
  const Network fine = carried(coarse, model.structure);
  const Eigen::VectorXd before = cable_lengths(coarse);
  const Eigen::VectorXd after = cable_lengths(fine);
  CHECK((before - after).cwiseAbs().maxCoeff() < 1e-2 * before.maxCoeff());
  const auto settled = equilibrium::solve(equilibrium::System(fine.structure), fine.state);
  CHECK(settled.usable());
  CHECK(sensitivity::deviation(target, settled.state).max_percent < 3.0);
}

TEST_CASE("A group carried to another resolution still maps the rods onto themselves") {
  const Model model = trefoil(144);
  const sensitivity::Target target{.points = model.positions};
  const auto problem = coarsened(model.structure, target, {});
  REQUIRE(problem);
  const auto fewer = carried(group_of(model), model.structure.rods, problem->structure.rods);
  const auto found = group_of({problem->structure, problem->target.points});
  REQUIRE(fewer.order() == found.order());
  const double length = problem->structure.rods[0].length();
  for (const auto& operation : fewer.operations) {
    double nearest = length;
    for (const auto& other : found.operations) {
      if ((other.matrix - operation.matrix).norm() > 1e-2) continue;
      nearest = std::min(nearest, std::abs(std::remainder(
                                      other.rods[0].offset - operation.rods[0].offset, length)));
    }
    CHECK(nearest < 1e-3 * length);
  }
}
