#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/model/structure.hpp>

#include "fixtures/rods.hpp"

using namespace tencer;

TEST_CASE("loads that do not name a rod are refused") {
  model::Structure structure = fixtures::hung_helix(12).structure;
  CHECK_NOTHROW(validate(structure));
  structure.point_loads = {{.rod = 1}};
  CHECK_THROWS_WITH(validate(structure), Catch::Contains("load"));
  structure.point_loads.clear();
  structure.line_loads = {{.rod = 0, .force_per_length = {NAN, 0, 0}}};
  CHECK_THROWS_WITH(validate(structure), Catch::Contains("load"));
}

TEST_CASE("cables tie rods into components, numbered by their first rods") {
  model::Structure structure = fixtures::chain(5, 12).structure;
  structure.anchors = Eigen::Vector3d::Zero();
  const auto tie = [&](const springs::End& a, const springs::End& b) {
    structure.cables.push_back({.a = a, .b = b});
    return components(structure);
  };
  CHECK(components(structure) == std::vector{0, 1, 2, 3, 4});
  CHECK(tie(springs::OnRod{1, 0.0}, springs::OnRod{1, 0.1}) == std::vector{0, 1, 2, 3, 4});
  CHECK(tie(springs::OnRod{4, 0.0}, springs::OnRod{1, 0.0}) == std::vector{0, 1, 2, 3, 1});
  CHECK(tie(springs::OnRod{2, 0.0}, springs::OnRod{3, 0.0}) == std::vector{0, 1, 2, 2, 1});
  // Anchors tie nothing together.
  CHECK(tie(springs::OnRod{0, 0.0}, springs::AtAnchor{0}) == std::vector{0, 1, 2, 2, 1});
  CHECK(tie(springs::AtAnchor{0}, springs::OnRod{1, 0.0}) == std::vector{0, 1, 2, 2, 1});
  CHECK(tie(springs::OnRod{3, 0.0}, springs::OnRod{4, 0.0}) == std::vector{0, 1, 1, 1, 1});
}
