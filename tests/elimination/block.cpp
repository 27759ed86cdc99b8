// Blocks of a network with many rods.
#include "moves/block.hpp"

#include <catch2/catch.hpp>
#include <tencer/elimination/options.hpp>
#include <tencer/ground_structure/force_balance.hpp>
#include <tencer/ground_structure/neighbours.hpp>

#include "fixtures/problems.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using namespace tencer::elimination;
using network::Network;

namespace {

constexpr double soft = BlockOptions{}.soft_rest_ratio;

// In equilibrium, with cables from each link to the next.
Network balanced_links(const Model& model) {
  auto problem = problem_of(model);
  problem.candidates = ground_structure::among_neighbours(problem.candidates, model.positions);
  const auto result = ground_structure::force_balance(problem, nullptr);
  REQUIRE(result.valid());
  return result.network;
}

}  // namespace

TEST_CASE("Blocks of a chain are its pairs of links, and what is tied to nothing is one too") {
  model::Structure structure = chain(4, 24).structure;
  const auto tie = [&](int a, int b) {
    structure.cables.push_back({.a = springs::OnRod{a, 0.1}, .b = springs::OnRod{b, 0.0}});
  };
  tie(1, 0);
  tie(0, 1);
  tie(2, 2);
  tie(1, 3);
  CHECK(joined_rods(structure) == std::vector<std::vector<int>>{{0, 1}, {1, 3}, {2}});
}

TEST_CASE("A block is in equilibrium while other rods are held, and put back changes nothing") {
  const Model model = chain(3, 32);
  const model::Target target{.points = model.positions};
  const Network whole = balanced_links(model);
  const Block block = block_of(whole, target, {}, {1, 2}, soft);
  REQUIRE(block.fixed_cables > 0);
  CHECK_FALSE(block.target.align);
  const equilibrium::System system(block.network.structure);
  CHECK(equilibrium::residual(system, block.network.state) < 1e-8);

  const Network again = with_block(whole, block, block.network);
  REQUIRE(cable_count(again) == cable_count(whole));
  const equilibrium::System same(again.structure);
  CHECK(equilibrium::residual(same, again.state) < 1e-8);
  const double before = force_densities(whole).sum();
  const double after = force_densities(again).sum();
  CHECK(after == Approx(before).epsilon(1e-9));
}

TEST_CASE("A block is seen from where the whole is") {
  const Model model = chain(3, 32);
  model::Target target{.points = model.positions, .views = {{.direction = {0.2, 0.1, 1}}}};
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 1, 0).normalized()).toRotationMatrix();
  for (auto& points : target.points) points = turn * points;
  target.views = model::turned(target.views, turn);
  const Block block = block_of(balanced_links(model), target, {}, {0, 1}, soft);
  REQUIRE(block.target.views.size() == 1);
  CHECK((block.target.views[0].direction - Eigen::Vector3d(0.2, 0.1, 1)).norm() < 0.02);
}

TEST_CASE("What is put back of a block replaces its cables and its rods only") {
  const Model model = chain(3, 32);
  const model::Target target{.points = model.positions};
  const Network whole = balanced_links(model);
  const Block block = block_of(whole, target, {}, {0, 1}, soft);
  Network changed = block.network;
  REQUIRE(cable_count(changed) > block.fixed_cables + 1);
  changed.structure.cables.pop_back();
  changed.state[0].x.array() += 0.01;
  const Network result = with_block(whole, block, changed);
  CHECK(cable_count(result) == cable_count(whole) - 1);
  CHECK(result.state[0].x.isApprox((whole.state[0].x.array() + 0.01).matrix()));
  CHECK(result.state[2].x == whole.state[2].x);
}
