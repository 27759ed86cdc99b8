// Every scene under examples/ can be read and prepared, and is what its comment says.
#include <filesystem>
#include <tencer/geometry/measure.hpp>
#include <tencer/io/file.hpp>

#include "scenes.hpp"

using namespace tencer;

namespace {

const std::filesystem::path examples = TENCER_EXAMPLES;

std::vector<std::filesystem::path> example_scenes() {
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(examples))
    if (entry.path().extension() == ".toml") scenes.push_back(entry.path());
  std::ranges::sort(scenes);
  return scenes;
}

io::Scene example(const std::string& name) { return scene_at(examples / name); }

}  // namespace

TEST_CASE("every example can be read and prepared") {
  const auto scenes = example_scenes();
  REQUIRE(scenes.size() >= 27);
  for (const auto& path : scenes) {
    CAPTURE(path);
    const io::Scene scene = scene_at(path);
    CHECK(prepared_of(scene).structure.rods.size() == scene.rods.size());

    std::vector<geometry::Polyline> targets;
    for (const auto& rod : scene.rods) targets.push_back(rod.target);
    CHECK(geometry::closest_approach(targets)->distance >
          0.001 * geometry::bounding_box_diagonal(targets));

    const auto text = io::read_file(path);
    REQUIRE(text);
    CHECK_THAT(*text, Catch::Matchers::StartsWith("# "));
    const std::string command =
        "#   tencer design " +
        (std::filesystem::path("examples") / std::filesystem::relative(path, examples)).string();
    CHECK_THAT(*text, Catch::Matchers::Contains(command));
  }
}

TEST_CASE("the owl is its own mirror image") {
  const io::Scene owl = example("paper/owl.toml");
  REQUIRE(owl.rods.size() == 3);
  for (const auto& rod : owl.rods) {
    const Eigen::Matrix3Xd& points = rod.target.points;
    const int n = rod.target.vertices();
    double worst = 0;
    for (int i = 0; i < n; ++i) {
      Eigen::Vector3d mirrored = points.col((n - i) % n);
      mirrored.x() = -mirrored.x();
      worst = std::max(worst, (points.col(i) - mirrored).norm());
    }
    CHECK(worst < 1e-6);
  }
}

TEST_CASE("the helix hangs in a cube") {
  const io::Scene helix = example("paper/helix.toml");
  REQUIRE(helix.anchors.cols() == 8);
  const Eigen::Vector3d size =
      helix.anchors.rowwise().maxCoeff() - helix.anchors.rowwise().minCoeff();
  CHECK(size.maxCoeff() == Approx(size.minCoeff()));
}
