#include "multilevel/coarsen.hpp"

#include <catch2/catch.hpp>
#include <tencer/ground_structure/force_balance.hpp>

#include "fixtures/problems.hpp"
#include "multilevel/transfer.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using elimination::coarsened;
using elimination::transferred;
using ground_structure::Problem;
using network::Network;

TEST_CASE("Rods that have hardly more vertices than they need keep them, their numbers rounded") {
  const Model model = trefoil(60);
  const auto same = coarsened(problem_of(model), {});
  REQUIRE(same);
  const Eigen::Matrix3Xd& rounded = same->target.points[0];
  REQUIRE(rounded.cols() == 60);
  const double edge = model.structure.rods[0].rest_lengths.mean();
  const double change = (rounded - model.positions[0]).cwiseAbs().maxCoeff();
  CHECK(change > 0);
  CHECK(change < 3e-4 * edge);
}

TEST_CASE("The rods of another resolution lie where those were, and there and back is nearby") {
  const Model model = trefoil(144);
  const Problem problem = problem_of(model);
  const auto coarse = coarsened(problem, {});
  REQUIRE(coarse);
  const int edges = coarse->structure.rods[0].edges();
  CHECK(edges < 100);
  CHECK(edges % 12 == 0);
  // A chord is shorter than its arc.
  CHECK(coarse->structure.rods[0].length() < model.structure.rods[0].length());
  CHECK(coarse->structure.rods[0].length() > 0.99 * model.structure.rods[0].length());

  const Network fewer = transferred(problem.bare(), coarse->structure);
  const double edge = coarse->structure.rods[0].rest_lengths.mean();
  CHECK((fewer.state[0].x - coarse->target.points[0]).cwiseAbs().maxCoeff() < 3e-4 * edge);
  const Network back = transferred(fewer, model.structure);
  const double size = model.positions[0].rowwise().norm().maxCoeff();
  CHECK((back.state[0].x - model.positions[0]).colwise().norm().maxCoeff() < 2e-4 * size);
}

TEST_CASE("A network taken to another resolution settles nearby, its ends in the same places") {
  const Model model = trefoil(144);
  const Problem problem = problem_of(model);
  const auto coarse = coarsened(problem, {});
  REQUIRE(coarse);
  const Network balanced =
      ground_structure::force_balance(*coarse, nullptr, {.max_error_percent = 0.5}).network;
  const Network fine = transferred(balanced, model.structure);
  const Eigen::VectorXd before = cable_lengths(balanced);
  const Eigen::VectorXd after = cable_lengths(fine);
  CHECK((before - after).cwiseAbs().maxCoeff() < 1e-2 * before.maxCoeff());
  const auto settled = equilibrium::solve(equilibrium::System(fine.structure), fine.state);
  CHECK(settled.usable());
  CHECK(sensitivity::deviation(problem.target, settled.state).max_percent < 3.0);
}

TEST_CASE("A group taken to another resolution still maps the rods onto themselves") {
  const Model model = trefoil(144);
  const auto coarse = coarsened(problem_of(model), {});
  REQUIRE(coarse);
  const auto fewer = transferred(group_of(model), model.structure.rods, coarse->structure.rods);
  const auto found = group_of({coarse->structure, coarse->target.points});
  REQUIRE(fewer.order() == found.order());
  const double length = coarse->structure.rods[0].length();
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
