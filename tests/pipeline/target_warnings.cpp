// Rods that the target puts through each other are told before the search.
#include "target_warnings.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace tencer;
using Catch::Matchers::Contains;

namespace {

// Of rods 1 cm in radius.
std::vector<std::string> warnings_of(const std::vector<geometry::Polyline>& curves) {
  model::Scene scene;
  for (const auto& curve : curves) {
    model::add_rod(scene, curve);
    scene.structure.rods.back().section = der::solid_circle(4e6, 0.3, 1);
  }
  return pipeline::target_warnings(scene, scene.structure,
                                   model::make_state(scene.structure, scene.target.points), 1);
}

geometry::Polyline line(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  constexpr int vertices = 41;
  geometry::Polyline curve{.points = Eigen::Matrix3Xd(3, vertices), .closed = false};
  for (int i = 0; i < vertices; ++i)
    curve.points.col(i) = from + (to - from) * i / (vertices - 1.0);
  return curve;
}

}  // namespace

TEST_CASE("each pair of rods that are nearer than they are thick is named with places and gap") {
  const auto along = line({0, 0, 0}, {400, 0, 0});
  const auto across = line({100, -150, 1.5}, {100, 250, 1.5});
  const auto above = line({300, -100, 1.9}, {300, 300, 1.9});
  const auto clear = line({200, -200, 2.1}, {200, 200, 2.1});
  CHECK(warnings_of({along, clear}).empty());
  const auto warnings = warnings_of({along, across, clear, above});
  REQUIRE(warnings.size() == 2);
  CHECK_THAT(warnings[0], Contains("rods A and B go through each other: A at 100 cm "
                                   "and B at 150 cm are 1.5 cm apart, axis to axis, "
                                   "where as thick as they are they need 2 cm"));
  CHECK_THAT(warnings[1], Contains("rods A and D go through each other: A at 300 cm "
                                   "and D at 100 cm are 1.9 cm apart"));
}

TEST_CASE("a rod that comes back to itself is named, one that only bends is not") {
  // A turn and a half, 200 cm in radius.
  const auto helix = [](double rise) {
    constexpr int vertices = 400;
    geometry::Polyline curve{.points = Eigen::Matrix3Xd(3, vertices), .closed = false};
    for (int i = 0; i < vertices; ++i) {
      const double turns = 1.5 * i / (vertices - 1.0);
      const double angle = 2 * std::numbers::pi * turns;
      curve.points.col(i) << 200 * std::cos(angle), 200 * std::sin(angle), rise * turns;
    }
    return curve;
  };
  CHECK(warnings_of({helix(2.5)}).empty());
  const auto warnings = warnings_of({helix(1.5)});
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Contains("the rod goes through itself: "));
  CHECK_THAT(warnings[0], Contains(" are 1.5 cm apart, axis to axis"));
}
