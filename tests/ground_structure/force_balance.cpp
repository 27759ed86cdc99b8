#include <catch2/catch.hpp>
#include <numbers>
#include <tencer/equilibrium/stability.hpp>
#include <tencer/ground_structure/force_balance.hpp>
#include <tencer/symmetry/orbit.hpp>
#include <tencer/symmetry/tie.hpp>

#include "fixtures/problems.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using ground_structure::force_balance;

TEST_CASE("Balance finds a stable network of pulling cables near the target") {
  for (const Model& model : {trefoil(), linked_ellipses(), hung_helix()}) {
    const auto problem = problem_of(model);
    const auto result = force_balance(problem, nullptr);
    CHECK(result.valid());
    CHECK(idle_cables(result.network).empty());
    CHECK(sensitivity::deviation(problem.target, result.network.state).max_percent < 0.5);
    CHECK(
        equilibrium::stability(equilibrium::System(result.network.structure), result.network.state)
            .stable());
  }
}

TEST_CASE("A finer balance uses more cables and is nearer") {
  const Model model = trefoil();
  const auto problem = problem_of(model);
  const auto coarse = force_balance(problem, nullptr, {.max_error_percent = 0.3});
  const auto fine = force_balance(problem, nullptr, {.max_error_percent = 0.03});
  CHECK(cable_count(fine.network) > cable_count(coarse.network));
  CHECK(max_percent(model, fine.network) < max_percent(model, coarse.network));
}

TEST_CASE("Balance keeps orbits of cables together") {
  const Model model = trefoil();
  const symmetry::Group group = group_of(model);
  REQUIRE(group.order() == 6);
  const auto result = force_balance(problem_of(model), &group);
  REQUIRE(result.valid());
  const auto& found = result.network.structure.cables;
  CHECK(symmetry::complete(found, group).size() == found.size());
  const auto ties = symmetry::tie_cables(found, group);
  const Eigen::VectorXd lengths = cable_lengths(result.network);
  std::vector<double> first(found.size(), 0.0);
  for (std::size_t c = 0; c < found.size(); ++c) {
    const int orbit = ties.orbit[c];
    if (first[orbit] == 0) first[orbit] = lengths[static_cast<Eigen::Index>(c)];
    CHECK(lengths[static_cast<Eigen::Index>(c)] == Approx(first[orbit]).epsilon(1e-6));
  }
}

TEST_CASE("Rods at rest in the target need no cables") {
  const Model model = make_model({geometry::Polyline{
      .points = Eigen::RowVectorXd::LinSpaced(20, 0, 1).replicate(3, 1), .closed = false}});
  const auto result = force_balance(problem_of(model), nullptr);
  CHECK(result.network.structure.cables.empty());
}

TEST_CASE("straight rods, which rest without cables, are tied into a form that stands") {
  // The three struts of a prism of cables (a tensegrity), twisted by 150 degrees.
  constexpr int vertices = 9;
  Model model;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2 * std::numbers::pi * k / 3;
    const double above = angle + 5 * std::numbers::pi / 6;
    const Eigen::Vector3d foot(0.12 * std::cos(angle), 0.12 * std::sin(angle), 0);
    const Eigen::Vector3d head(0.12 * std::cos(above), 0.12 * std::sin(above), 0.24);
    Eigen::Matrix3Xd x(3, vertices);
    for (int i = 0; i < vertices; ++i) x.col(i) = foot + (head - foot) * i / (vertices - 1.0);
    der::Rod rod;
    rod.section = {.EA = 1e5, .EI1 = 1, .EI2 = 1, .GJ = 2.0 / 3};
    rod.rest_lengths =
        Eigen::VectorXd::Constant(vertices - 1, (head - foot).norm() / (vertices - 1));
    model.structure.rods.push_back(rod);
    model.positions.push_back(x);
  }
  const auto stage = ground_structure::force_balance(problem_of(model), nullptr);
  REQUIRE(stage.valid());
  CHECK(model::components(stage.network.structure) == std::vector<int>{0, 0, 0});
  CHECK(network::cable_tensions(stage.network).minCoeff() > 0);
}

TEST_CASE("Where a balance of few cables buckles, the cables are those of the rest with all tied") {
  // A long flat ring: all balances slip into another shape, 4 % away.
  const Model model = make_model({curves::ellipse(20, 1, 100)});
  const auto problem = problem_of(model);
  const auto result = force_balance(problem, nullptr, {.max_error_percent = 0.1});
  CHECK(result.valid());
  CHECK(max_percent(model, result.network) < 0.1);
}
