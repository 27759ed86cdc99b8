// What a scene asks of its design.
#include <catch2/catch.hpp>
#include <tencer/io/scene.hpp>

#include "curves_folder.hpp"

using namespace tencer;
using namespace tencer::io;
using Catch::Matchers::Contains;

TEST_CASE("a target is seen from one side, from several, or in space") {
  const Curves folder;
  const std::string ring = "[[rod]]\ncurve = 'ring.obj'\n[design]\n";
  CHECK(folder.scene(ring).target.views.empty());
  const auto one = folder.scene(ring + "view = [0, 1, 2]\n").target.views;
  REQUIRE(one.size() == 1);
  CHECK(one[0].direction == Eigen::Vector3d(0, 1, 2));
  const auto two = folder.scene(ring + "view = [[1, 0, 0], [0, 0, 2]]\n").target.views;
  REQUIRE(two.size() == 2);
  CHECK(two[1].direction == Eigen::Vector3d(0, 0, 2));
  CHECK(two[1].weight == 1);
  const auto heavy =
      folder.scene(ring + "view = [{direction = [1, 0, 0]}, {direction = [0, 1, 0], weight = 3}]\n")
          .target.views;
  REQUIRE(heavy.size() == 2);
  CHECK(heavy[0].weight == 1);
  CHECK(heavy[1].weight == 3);
}

TEST_CASE("symmetries in a scene") {
  const Curves folder;
  const std::string rod = "[[rod]]\ncurve = 'ring.obj'\n[design]\n";
  using model::SymmetryUse;
  CHECK(folder.scene(rod).design.symmetry == SymmetryUse::suggest);
  for (const auto& [word, use] : {std::pair{"none", SymmetryUse::none},
                                  {"offer", SymmetryUse::suggest},
                                  {"detect", SymmetryUse::detect}})
    CHECK(folder.scene(rod + "symmetry = '" + word + "'").design.symmetry == use);
  const auto given =
      folder.scene(rod +
                   "symmetry = [{fold = 4, axis = [0, 0, 2]}, {normal = [1, 0, 0], point = "
                   "[2, 2, 0]}]");
  CHECK(given.design.symmetry == SymmetryUse::given);
  REQUIRE(given.generators.size() == 2);
  const auto& rotation = std::get<model::Rotation>(given.generators[0]);
  CHECK(rotation.fold == 4);
  CHECK(rotation.axis == Eigen::Vector3d(0, 0, 2));
  CHECK_FALSE(rotation.point);
  const auto& reflection = std::get<model::Reflection>(given.generators[1]);
  CHECK(reflection.normal == Eigen::Vector3d::UnitX());
  CHECK(*reflection.point == Eigen::Vector3d(2, 2, 0));

  const auto error = [&](const std::string& value) {
    return folder.error(rod + "symmetry = " + value);
  };
  CHECK_THAT(error("'some'"), Contains("s.toml:4: design.symmetry: expected one of"));
  CHECK_THAT(error("[3]"), Contains("design.symmetry[0]: expected a table"));
  CHECK_THAT(error("[{fold = 1, axis = [0, 0, 1]}]"), Contains("a whole number from 2"));
  CHECK_THAT(error("[{fold = 3}]"), Contains("the key design.symmetry[0].axis is missing"));
  CHECK_THAT(error("[{axis = [0, 0, 1]}]"), Contains("the key design.symmetry[0].fold is missing"));
  CHECK_THAT(error("[{normal = [0, 0, 0]}]"),
             Contains("design.symmetry[0].normal: must not be zero"));
  CHECK_THAT(error("[{fold = 2, normal = [0, 0, 1]}]"), Contains("make them two tables"));
  CHECK_THAT(error("[{mirror = [0, 0, 1]}]"), Contains("unknown key design.symmetry[0].mirror"));
}

TEST_CASE("pins are handed over only where there are pins and anchors") {
  const Curves folder;
  const std::string design = "[[rod]]\ncurve = 'line.csv'\n[design]\nhand_over = true\n";
  const std::string pinned = "pinned = [{rod = 0, vertex = 0}]\n";
  const std::string frame = "frame = {shape = 'cube'}\n";
  CHECK(folder.scene(pinned + frame + design).design.hand_over);
  CHECK_FALSE(folder.scene("[[rod]]\ncurve = 'line.csv'").design.hand_over);
  CHECK(folder.error(frame + design) ==
        "s.toml:5: design.hand_over: is true, but the scene has no pinned vertices to hand over");
  CHECK_THAT(folder.error(pinned + design), Contains("design.hand_over: is true, but the scene has "
                                                     "no anchors to hand its pins over to"));
}
