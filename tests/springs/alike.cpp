#include <catch2/catch.hpp>
#include <tencer/springs/alike.hpp>
#include <vector>

using namespace tencer;
using springs::alike;
using springs::AtAnchor;
using springs::Cable;
using springs::OnRod;

TEST_CASE("cables are alike when both ends are near, in either order and across the seam") {
  const std::vector<geometry::ArcLength> rods{{Eigen::VectorXd::Constant(10, 1.0), true},
                                              {Eigen::VectorXd::Constant(10, 1.0), false}};
  const Cable cable{.a = OnRod{0, 0.1}, .b = OnRod{1, 5.0}};
  const auto like = [&](const Cable& other) { return alike(cable, other, rods, 0.05); };
  CHECK(like(cable));
  CHECK(like({.a = OnRod{1, 5.4}, .b = OnRod{0, 9.8}}));
  CHECK(like({.a = OnRod{0, 20.0}, .b = OnRod{1, 4.6}}));
  CHECK_FALSE(like({.a = OnRod{0, 0.1}, .b = OnRod{1, 5.6}}));
  CHECK_FALSE(like({.a = OnRod{0, 9.5}, .b = OnRod{1, 5.0}}));
  CHECK_FALSE(like({.a = OnRod{0, 0.1}, .b = OnRod{0, 5.0}}));
  CHECK_FALSE(like({.a = OnRod{0, 0.1}, .b = AtAnchor{0}}));
  // An open rod has no seam.
  const Cable end{.a = OnRod{0, 0.0}, .b = OnRod{1, 0.0}};
  CHECK_FALSE(alike(end, {.a = OnRod{0, 0.0}, .b = OnRod{1, 10.0}}, rods, 0.05));
  const Cable held{.a = OnRod{0, 2.0}, .b = AtAnchor{1}};
  CHECK(alike(held, {.a = AtAnchor{1}, .b = OnRod{0, 2.3}}, rods, 0.05));
  CHECK_FALSE(alike(held, {.a = AtAnchor{0}, .b = OnRod{0, 2.0}}, rods, 0.05));
}
