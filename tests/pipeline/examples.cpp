// Every scene under examples/ can be read and prepared, and is what its comment says.
#include <filesystem>
#include <tencer/geometry/measure.hpp>
#include <tencer/io/file.hpp>

#include "scenes.hpp"

using namespace tencer;

namespace {

const std::filesystem::path examples = TENCER_EXAMPLES;

// Of an actuation: steps, no rods.
bool is_schedule(const std::filesystem::path& path) {
  return io::read_file(path).value().find("[[step]]") != std::string::npos;
}

std::vector<std::filesystem::path> example_scenes() {
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(examples))
    if (entry.path().extension() == ".toml" && !is_schedule(entry.path()))
      scenes.push_back(entry.path());
  std::ranges::sort(scenes);
  return scenes;
}

model::Scene example(const std::string& name) { return scene_at(examples / name); }

}  // namespace

TEST_CASE("every example can be read and prepared") {
  const auto scenes = example_scenes();
  REQUIRE(scenes.size() >= 27);
  for (const auto& path : scenes) {
    CAPTURE(path);
    const model::Scene scene = scene_at(path);
    CHECK(prepared_of(scene).problem.structure.rods.size() == scene.structure.rods.size());

    const std::vector<geometry::Polyline> targets = target_curves(scene);
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
  const model::Scene owl = example("paper/owl.toml");
  REQUIRE(owl.structure.rods.size() == 3);
  for (const Eigen::Matrix3Xd& points : owl.target.points) {
    const auto n = static_cast<int>(points.cols());
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
  const model::Scene helix = example("paper/helix.toml");
  const Eigen::Matrix3Xd& anchors = helix.structure.anchors;
  REQUIRE(anchors.cols() == 8);
  const Eigen::Vector3d size = anchors.rowwise().maxCoeff() - anchors.rowwise().minCoeff();
  CHECK(size.maxCoeff() == Approx(size.minCoeff()));
}
