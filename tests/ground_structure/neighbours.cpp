// Which rods are neighbours.
#include <algorithm>
#include <catch2/catch.hpp>
#include <tencer/ground_structure/neighbours.hpp>

#include "fixtures/problems.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using namespace tencer::ground_structure;

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
