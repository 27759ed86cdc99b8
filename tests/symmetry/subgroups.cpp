#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <set>
#include <tencer/symmetry/detect.hpp>
#include <tencer/symmetry/subgroups.hpp>
#include <utility>

#include "figures.hpp"

using namespace tencer::symmetry;

TEST_CASE("Subgroups are groups, the largest first") {
  // Three Borromean ellipses: the pyritohedral group, of order 24.
  const Group group = detect(figure_of(tencer::curves::borromean_ellipses(5.0, 3.0, 96))).group;
  REQUIRE(group.order() == 24);
  const auto found = subgroups(group, 24);
  std::set<int> orders;
  int last = 24;
  for (const Group& sub : found) {
    orders.insert(sub.order());
    CHECK(sub.order() <= last);
    last = sub.order();
    CHECK(24 % sub.order() == 0);
    for (int a = 0; a < sub.order(); ++a)
      for (int b = 0; b < sub.order(); ++b) {
        const auto& made = sub.operations[sub.product(a, b)].matrix;
        CHECK((sub.operations[a].matrix * sub.operations[b].matrix - made).norm() < 1e-9);
      }
  }
  // The one of order 8 takes three operations to make.
  CHECK(orders == std::set<int>{2, 3, 4, 6, 12, 24});
  for (const Group& sub : subgroups(group, 6)) CHECK(sub.order() <= 6);
}
