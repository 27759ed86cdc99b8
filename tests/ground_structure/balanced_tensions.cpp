// The balance of forces against its own optimality conditions.
#include <catch2/catch.hpp>
#include <tencer/ground_structure/balanced_tensions.hpp>

#include "fixtures/problems.hpp"

using namespace tencer;

TEST_CASE("balanced tensions are nonnegative, and no other tension would bring the forces closer") {
  const auto problem = fixtures::problem_of(fixtures::trefoil());
  const equilibrium::System system(problem.structure);
  const auto orbits =
      ground_structure::candidate_orbits(system, problem.start, problem.candidates, nullptr);
  // Accuracy 0: the least squares solution itself.
  const auto found = ground_structure::balanced_tensions(system, problem.start, orbits, 0.0);
  const auto moved = ground_structure::displacements(system, problem.start, orbits);
  REQUIRE(found);
  REQUIRE(moved);
  REQUIRE(found->converged());
  REQUIRE_FALSE(found->set.empty());
  CHECK(found->values.minCoeff() > 0);
  Eigen::VectorXd rest = moved->goal;
  for (std::size_t i = 0; i < found->set.size(); ++i)
    rest -= found->values[static_cast<Eigen::Index>(i)] * moved->columns.col(found->set[i]);
  const Eigen::VectorXd slope = moved->columns.transpose() * rest;
  const double scale = (moved->columns.transpose() * moved->goal).cwiseAbs().maxCoeff();
  CHECK(slope.maxCoeff() < 1e-8 * scale);  // none that is zero wants to grow
  for (const int c : found->set) CHECK(std::abs(slope[c]) < 1e-8 * scale);
}

TEST_CASE("balanced tensions leave no vertex further to move than the accuracy") {
  const auto problem = fixtures::problem_of(fixtures::linked_ellipses());
  const equilibrium::System system(problem.structure);
  const auto orbits =
      ground_structure::candidate_orbits(system, problem.start, problem.candidates, nullptr);
  const auto moved = ground_structure::displacements(system, problem.start, orbits);
  REQUIRE(moved);
  std::size_t last = 0;
  for (const double accuracy : {1e-3, 1e-4}) {
    const auto found = ground_structure::balanced_tensions(system, problem.start, orbits, accuracy);
    REQUIRE(found);
    Eigen::VectorXd rest = moved->goal;
    for (std::size_t i = 0; i < found->set.size(); ++i)
      rest -= found->values[static_cast<Eigen::Index>(i)] * moved->columns.col(found->set[i]);
    const Eigen::VectorXd distances =
        rest.reshaped(3, rest.size() / 3).colwise().norm().transpose();
    CHECK(distances.maxCoeff() <= accuracy);
    CHECK(found->set.size() > last);  // a finer balance takes more cables
    last = found->set.size();
  }
}

TEST_CASE("without candidates nothing is balanced") {
  const auto problem = fixtures::problem_of(fixtures::trefoil());
  const equilibrium::System system(problem.structure);
  const auto found = ground_structure::balanced_tensions(system, problem.start, {}, 1e-4);
  REQUIRE(found);
  CHECK(found->converged());
  CHECK(found->set.empty());
}

TEST_CASE("a rod whose edges are too unlike for its stiffness to be finite has no balance") {
  auto problem = fixtures::problem_of(fixtures::trefoil());
  problem.structure.rods[0].section.EA = 1e308;
  const equilibrium::System system(problem.structure);
  const auto orbits =
      ground_structure::candidate_orbits(system, problem.start, problem.candidates, nullptr);
  CHECK_FALSE(ground_structure::balanced_tensions(system, problem.start, orbits, 1e-4));
  CHECK_FALSE(ground_structure::displacements(system, problem.start, orbits));
}
