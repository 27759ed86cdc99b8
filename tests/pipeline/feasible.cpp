#include <catch2/catch.hpp>
#include <numbers>
#include <random>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/feasible.hpp>

#include "scenes.hpp"

using namespace tencer;
using model::Verdict;

namespace {

// The letter S, of two arcs.
model::Scene letter(bool planar = false) {
  constexpr int half = 40;
  geometry::Polyline arcs{.points = Eigen::Matrix3Xd(3, 2 * half - 1), .closed = false};
  for (int i = 0; i < half; ++i) {
    const double angle = std::numbers::pi * (0.1 + 1.4 * i / (half - 1));
    arcs.points.col(i) << std::cos(angle), 1 + std::sin(angle), 0;
    arcs.points.col(2 * half - 2 - i) << -std::cos(angle), -1 - std::sin(angle), 0;
  }
  arcs.points *= 10;
  model::Scene scene = model::scene_of({arcs}, "S");
  scene.structure.planar = planar;
  return scene;
}

const model::Mend* mend(const model::Feasibility& feasibility, const std::string& part) {
  for (const model::Mend& one : feasibility.mends)
    if (one.change.find(part) != std::string::npos) return &one;
  return nullptr;
}

}  // namespace

TEST_CASE("a knot can be held, also with many vertices") {
  for (const int vertices : {60, 1000}) {
    const auto found = pipeline::feasible(trefoil_scene(vertices));
    REQUIRE(found);
    CHECK(found->verdict == Verdict::can);
    CHECK(found->percent < 0.1);
    CHECK(found->mends.empty());
    CHECK(found->vertices < 150);
  }
}

TEST_CASE("a letter cannot be held by cables across it; what would hold it is tried") {
  const auto found = pipeline::feasible(letter());
  REQUIRE(found);
  CHECK(found->verdict == Verdict::cannot);
  CHECK(found->percent > 5);
  CHECK(found->released > 0);
  CHECK(found->lengthening < 0.003);
  REQUIRE(found->motions.size() == 1);
  CHECK(found->motions[0].cols() == found->targets[0].vertices());
  for (const char* helps : {"frame", "planar"}) {
    REQUIRE(mend(*found, helps));
    CHECK(mend(*found, helps)->helps);
  }
  REQUIRE(mend(*found, "smoothed"));
  CHECK_FALSE(mend(*found, "smoothed")->helps);
  CHECK(report(*found).find("cannot be held") == 0);
  CHECK(reason(*found).find("frame = {shape") != std::string::npos);

  const auto flat = pipeline::feasible(letter(true));
  REQUIRE(flat);
  CHECK(flat->verdict == Verdict::can);
}

TEST_CASE("the motion is that of the proof: its largest is the distance that is told") {
  const auto found = pipeline::feasible(letter(), {.mends = pipeline::TryMends::never});
  REQUIRE(found);
  const double size = (found->targets[0].points.rowwise().maxCoeff() -
                       found->targets[0].points.rowwise().minCoeff())
                          .norm();
  CHECK(100 * found->motions[0].colwise().norm().maxCoeff() / size ==
        Approx(found->percent).epsilon(1e-6));
}

TEST_CASE("a design of what cannot be held ends before the search") {
  const auto design = pipeline::design(letter());
  REQUIRE_FALSE(design);
  CHECK(design.error().message.find("cables alone cannot hold this shape") == 0);
}

TEST_CASE("rods that lie apart cannot be tied to each other, but in a frame") {
  auto rings = std::vector<geometry::Polyline>(2, curves::ellipse(32.5, 25, 30));
  rings[1].points.row(2).array() += 20;
  const auto found = pipeline::feasible(scene_of(rings));
  REQUIRE(found);
  CHECK(found->verdict == Verdict::cannot);
  CHECK(found->apart.size() == 1);
  REQUIRE(mend(*found, "frame"));
  CHECK(mend(*found, "frame")->helps);
  CHECK(reason(*found).find("lies apart from the others") != std::string::npos);
}

TEST_CASE("a rule that is in the way is found by lifting it") {
  model::Scene scene = trefoil_scene(60);
  const double size =
      (scene.target.points[0].rowwise().maxCoeff() - scene.target.points[0].rowwise().minCoeff())
          .norm();
  scene.rules.max_cable_length = 0.2 * size;
  const auto found = pipeline::feasible(scene);
  REQUIRE(found);
  CHECK(found->verdict != Verdict::can);
  REQUIRE(mend(*found, "longest_cable"));
  CHECK(mend(*found, "longest_cable")->helps);
}

TEST_CASE("noise is mended by smoothing") {
  model::Scene scene = trefoil_scene(120);
  auto& points = scene.target.points[0];
  const double size = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.004 * size);
  for (double& x : points.reshaped()) x += noise(random);
  scene.structure.rods[0].rest_lengths = geometry::edge_lengths(model::target_curve(scene, 0));
  const auto found = pipeline::feasible(scene);
  REQUIRE(found);
  CHECK(found->verdict != Verdict::can);
  REQUIRE(found->warnings.size() == 1);
  CHECK(found->warnings[0].find("rough") != std::string::npos);
  REQUIRE(mend(*found, "smoothed"));
  CHECK(mend(*found, "smoothed")->helps);
}

TEST_CASE("very many rods are left to the search") {
  std::vector<geometry::Polyline> rings(30, curves::ellipse(32.5, 25, 24));
  for (std::size_t r = 0; r < rings.size(); ++r)
    rings[r].points.row(0).array() += 40 * static_cast<double>(r);
  for (std::size_t r = 1; r < rings.size(); r += 2)
    rings[r].points.row(1).swap(rings[r].points.row(2));
  const auto found = pipeline::feasible(scene_of(rings));
  REQUIRE(found);
  CHECK(found->verdict == Verdict::unclear);
  CHECK(found->cables == 0);
  CHECK(found->targets.empty());
  CHECK(report(*found).find("unclear: so many rods") == 0);
}
