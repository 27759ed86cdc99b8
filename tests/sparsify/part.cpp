// Parts of a network with many rods, and which rods are neighbours.
#include "part.hpp"

#include <catch2/catch.hpp>
#include <tencer/sparsify/balance.hpp>

#include "local_model.hpp"
#include "models.hpp"
#include "neighbours.hpp"
#include "walker.hpp"

using namespace tencer;
using namespace tencer::sparsify;
using namespace tencer::sparsify::test;

namespace {

// Bent ellipses, each through the next and at right angles to it.
Model chain(int rods, int vertices) {
  std::vector<geometry::Polyline> links;
  for (int r = 0; r < rods; ++r) {
    geometry::Polyline link = curves::ellipse(1.3, 1.0, vertices);
    for (int i = 0; i < vertices; ++i)
      link.points(2, i) = 0.2 * std::cos(4 * M_PI * i / vertices + 0.1 * r);
    if (r % 2 == 1) link.points.row(1).swap(link.points.row(2));
    link.points.row(0).array() += 1.8 * r;
    links.push_back(std::move(link));
  }
  return make_model(links);
}

// In equilibrium, with cables from each link to the next.
Network balanced(const Model& model, const sensitivity::Target& target) {
  const Network bare{model.structure, equilibrium::make_state(model.structure, model.positions)};
  const auto cables =
      among_neighbours(candidates(model.structure, model.positions, {}).value(), model.positions);
  const StageResult result = balance(bare, target, cables, nullptr, {.percent = 0.1});
  REQUIRE(result.sound);
  return result.network;
}

double force_density(const Network& network, std::size_t cable) {
  return cable_tensions(network)[static_cast<Eigen::Index>(cable)] /
         cable_lengths(network)[static_cast<Eigen::Index>(cable)];
}

}  // namespace

TEST_CASE("Neighbours are those that no third is between") {
  const auto at = [](double x, double y) {
    Eigen::Matrix3Xd points(3, 2);
    points << x, x + 0.1, y, y, 0, 0;
    return points;
  };
  using Pairs = std::set<std::pair<int, int>>;
  CHECK(relative_neighbours({}).empty());
  CHECK(relative_neighbours({at(0, 0), at(1, 0), at(2, 0), at(9, 0)}) ==
        Pairs{{0, 1}, {1, 2}, {2, 3}});
  CHECK(relative_neighbours({at(0, 0), at(1, 0), at(0.5, 0.9)}) == Pairs{{0, 1}, {0, 2}, {1, 2}});
  CHECK(relative_neighbours({at(0, 0), at(1, 0), at(0, 1), at(1, 1)}).size() == 4);
}

TEST_CASE("Only cables between rods that are no neighbours are left out") {
  const Model model = chain(4, 24);
  const auto all = candidates(model.structure, model.positions, {}).value();
  const auto near = among_neighbours(all, model.positions);
  CHECK(near.size() < all.size());
  const auto apart = [](const springs::Cable& cable) {
    return std::abs(std::get<springs::OnRod>(cable.a).rod - std::get<springs::OnRod>(cable.b).rod);
  };
  CHECK(std::ranges::all_of(near, [&](const auto& cable) { return apart(cable) <= 1; }));
  CHECK(static_cast<std::ptrdiff_t>(near.size()) ==
        std::ranges::count_if(all, [&](const auto& cable) { return apart(cable) <= 1; }));
}

TEST_CASE("Parts of a chain are its pairs of links, and what is tied to nothing is one too") {
  equilibrium::Structure structure = chain(4, 24).structure;
  const auto tie = [&](int a, int b) {
    structure.cables.push_back({.a = springs::OnRod{a, 0.1}, .b = springs::OnRod{b, 0.0}});
  };
  tie(1, 0);
  tie(0, 1);
  tie(2, 2);
  tie(1, 3);
  CHECK(joined_rods(structure) == std::vector<std::vector<int>>{{0, 1}, {1, 3}, {2}});
}

TEST_CASE("A part is in equilibrium while other rods are held, and put back changes nothing") {
  const Model model = chain(3, 32);
  const sensitivity::Target target{.points = model.positions};
  const Network whole = balanced(model, target);
  const Part part = part_of(whole, target, {}, {1, 2});
  REQUIRE(part.kept > 0);
  CHECK_FALSE(part.target.align);
  const equilibrium::System system(part.network.structure);
  CHECK(equilibrium::residual(system, part.network.state) < 1e-8);

  const Network again = with_part(whole, part, part.network);
  REQUIRE(cables(again) == cables(whole));
  const equilibrium::System same(again.structure);
  CHECK(equilibrium::residual(same, again.state) < 1e-8);
  double before = 0;
  double after = 0;
  for (std::size_t c = 0; c < again.structure.cables.size(); ++c) {
    before += force_density(whole, c);
    after += force_density(again, c);
  }
  CHECK(after == Approx(before).epsilon(1e-9));
}

TEST_CASE("What is put back of a part replaces its cables and its rods only") {
  const Model model = chain(3, 32);
  const sensitivity::Target target{.points = model.positions};
  const Network whole = balanced(model, target);
  const Part part = part_of(whole, target, {}, {0, 1});
  Network changed = part.network;
  REQUIRE(cables(changed) > part.kept + 1);
  changed.structure.cables.pop_back();
  changed.state[0].x.array() += 0.01;
  const Network result = with_part(whole, part, changed);
  CHECK(cables(result) == cables(whole) - 1);
  CHECK(result.state[0].x.isApprox((whole.state[0].x.array() + 0.01).matrix()));
  CHECK(result.state[2].x == whole.state[2].x);
}

TEST_CASE("Cables that are kept are no variables, and leave the rates of others as they are") {
  const Model model = trefoil(40);
  const Network network = decimated(model, 10.0);
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
