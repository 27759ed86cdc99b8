// Scenes in the keys of the file that a program says itself.
#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/io/scene.hpp>
#include <variant>

#include "fixtures/folder.hpp"

using namespace tencer;

namespace {

geometry::Polyline ring(double size) {
  Eigen::Matrix3Xd points(3, 40);
  for (int i = 0; i < 40; ++i) {
    const double t = 2 * M_PI * i / 40;
    points.col(i) << size * std::cos(t), size * std::sin(t), 0;
  }
  return {points, true};
}

double radius(const model::Scene& scene, std::size_t rod = 0) {
  return std::get<der::Circle>(scene.structure.rods[rod].section.shape).radius;
}

}  // namespace

TEST_CASE("Keys make a scene by themselves, with curves in memory by their numbers") {
  const auto scene = io::scene_of_keys(
      {.text = "rod = [{curve = 1}, {curve = 0, section = {radius = 0.2}}]\n"
               "section = {radius = 0.1}\nmax_error = 0.5\nbuild = {length_error = 0}\n",
       .curves = {ring(10), ring(20)}},
      "rings");
  REQUIRE(scene);
  CHECK(scene->name == "rings");
  CHECK(scene->target.points[0](0, 0) == 20);
  CHECK(radius(*scene, 0) == 0.1);  // of every rod
  CHECK(radius(*scene, 1) == 0.2);  // but one that says its own
  CHECK(scene->design.max_error == 0.5);
  CHECK(scene->build.length_error == 0.0);
}

TEST_CASE("Wrong keys are named without a place") {
  const auto error_of = [](const char* text) {
    const auto scene = io::scene_of_keys({.text = text, .curves = {ring(10)}}, "rings");
    REQUIRE(!scene);
    return scene.error().text();
  };
  CHECK(error_of("rod = [{curve = 1}]") ==
        "rod[0].curve: expected a whole number of at most 0, found 1");
  CHECK(error_of("max_eror = 1") == "unknown key max_eror; did you mean max_error?");
  CHECK(error_of("rod = [{curve = 0}]\ntime = -1") ==
        "design.time: expected a positive number, found -1");
  CHECK(error_of("time = 1") == "a scene needs at least one [[rod]] table");
}

TEST_CASE("Keys take the place of what a file says") {
  const Folder folder;
  const auto path = folder.put("s.toml",
                               "rod = [{family = 'circle', section = {radius = 0.2}}]\n"
                               "[design]\ncables = 4\neffort = 1\n");
  const auto scene = io::scene_with_keys(path, {.text = "section = {radius = 0.1}\nmax_error = 2"});
  REQUIRE(scene);
  CHECK(radius(*scene) == 0.1);
  CHECK(!scene->design.cables);  // which would decide
  CHECK(scene->design.max_error == 2);
  CHECK(scene->design.effort == 1);  // what nobody says again stays
}

TEST_CASE("Keys of bare curves: in the file's unit, or another") {
  const Folder folder;
  const auto path = folder.put("c.csv", "x,y,z\n0,0,0\n1,0,0\n2,1,0\n3,1,0\n");
  const auto plain = io::read_any_scene(path);
  const auto same = io::scene_with_keys(path, {.text = "max_error = 1.0"});
  REQUIRE(same);
  CHECK(same->name == plain->name);
  CHECK(same->target.points[0] == plain->target.points[0]);
  CHECK(radius(*same) == radius(*plain));
  const auto feet = io::scene_with_keys(path, {.text = "length_unit = 'ft'"});
  REQUIRE(feet);
  CHECK(feet->length_unit == "cm");
  CHECK(feet->target.points[0](0, 1) == Approx(30.48));
}
