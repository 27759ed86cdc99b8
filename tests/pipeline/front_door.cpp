// What the front door's options do to a scene.
#include <catch2/catch.hpp>
#include <tencer/design.hpp>

using namespace tencer;
using Catch::Matchers::Contains;

TEST_CASE("errors of building are the options', or else the scene's") {
  model::Scene scene;
  scene.build.attachment_error = 0.5;
  model::add_rod(scene, {.points = Eigen::Matrix3Xd::Identity(3, 3), .closed = false});
  scene.structure.rods[0].section = round_rod(4e6, 0.1);
  const auto asked =
      with_options(scene, {.length_error = 0.05, .max_deviation = model::Allowance{2, "mm"}});
  REQUIRE(asked);
  CHECK(asked->build.length_error == 0.05);
  CHECK(asked->build.attachment_error == 0.5);
  CHECK(asked->build.max_deviation->length("cm", 100) == Approx(0.2));
  const auto wrong = with_options(scene, {.attachment_error = -1});
  REQUIRE_FALSE(wrong);
  CHECK_THAT(wrong.error().text(),
             Contains("DesignOptions: attachment_error must not be negative"));
}
