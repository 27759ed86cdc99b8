// Symmetries that a scene gives, or asks to have found: verified, offered, and kept by the cables.
#include <numbers>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/springs/cable.hpp>
#include <tencer/symmetry/orbit.hpp>

#include "scenes.hpp"

using namespace tencer;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using model::SymmetryUse;

namespace {

const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();

int order(const model::Scene& scene) {
  const auto problem = prepared_of(scene).problem;
  return problem.symmetry ? problem.symmetry->order() : 1;
}

// An ellipse in the plane z = 0: two mirror planes and the plane itself.
model::Scene detected_ellipse() {
  model::Scene scene = ellipse_scene(40);
  scene.design.symmetry = SymmetryUse::detect;
  return scene;
}

std::string given_error(model::Scene scene, const model::SymmetryGenerator& generator) {
  scene.design.symmetry = SymmetryUse::given;
  scene.generators = {generator};
  const auto result = pipeline::prepare(scene);
  return result ? "no error" : result.error().text();
}

// Whether the design's cables are mapped onto each other, and orbits have the same tension.
void check_symmetric(const model::Scene& scene, const model::Design& design) {
  const auto ready = prepared_of(scene);
  const auto& group = ready.problem.symmetry;
  REQUIRE(group);
  std::vector<springs::Cable> cables = design.structure.cables;
  for (std::size_t c = 0; c < cables.size(); ++c) {
    cables[c].stiffness = design.built[c].tension;
    for (springs::End* end : {&cables[c].a, &cables[c].b})
      if (auto* on_rod = std::get_if<springs::OnRod>(end)) on_rod->s /= ready.scaling.scale.length;
  }
  CHECK(symmetry::complete(cables, *group).size() == cables.size());
  for (const auto& cable : cables)
    for (const auto& image : symmetry::complete(std::vector{cable}, *group)) {
      const bool there = std::ranges::any_of(cables, [&](const springs::Cable& other) {
        return symmetry::complete(std::vector{other, image}, *group).size() ==
                   symmetry::complete(std::vector{image}, *group).size() &&
               other.stiffness == Approx(cable.stiffness).epsilon(1e-6);
      });
      CHECK(there);
    }
}

}  // namespace

TEST_CASE("a design keeps the rotations that its scene gives, and only then has to") {
  model::Scene scene = trefoil_scene(60);
  const model::Design without = designed(scene);
  CHECK(without.status == model::DesignStatus::complete);

  scene.design.symmetry = SymmetryUse::given;
  scene.generators = {model::Rotation{.fold = 3, .axis = z}};
  CHECK(order(scene) == 3);
  const model::Design with = designed(scene);
  CHECK(with.status == model::DesignStatus::complete);
  CHECK(with.structure.cables.size() % 3 == 0);
  check_symmetric(scene, with);
  check_consistent(with);
}

TEST_CASE("two rods with many symmetries are held by few orbits") {
  const auto knots = curves::twin_trefoils(27, 10.8, 72);
  model::Scene scene = scene_of({knots.begin(), knots.end()});
  scene.rules.pairs = {{0, 1}};
  scene.build.length_error = scene.build.attachment_error = 0;  // which take most of the time
  scene.design.max_error = 5.4;
  scene.design.symmetry = SymmetryUse::detect;
  CHECK(order(scene) == 12);
  const model::Design design = designed(scene);
  CHECK(design.status == model::DesignStatus::complete);
  check_symmetric(scene, design);
}

TEST_CASE("generators make a group, and what is found is the same") {
  model::Scene scene = trefoil_scene(60);
  CHECK(order(scene) == 1);
  scene.design.symmetry = SymmetryUse::given;
  scene.generators = {model::Rotation{.fold = 3, .axis = z},
                      model::Rotation{.fold = 2, .axis = Eigen::Vector3d::UnitY()}};
  CHECK(order(scene) == 6);
  scene.design.symmetry = SymmetryUse::detect;
  CHECK(order(scene) == 6);
  scene.design.symmetry = SymmetryUse::none;
  CHECK(order(scene) == 1);
}

TEST_CASE("an axis is through the rods' centroid, or where its point says") {
  model::Scene scene = trefoil_scene(60);
  retarget(scene, 0, scene.target.points[0].colwise() + Eigen::Vector3d(500, 0, 30));
  scene.design.symmetry = SymmetryUse::given;
  scene.generators = {model::Rotation{.fold = 3, .axis = 2 * z}};
  CHECK(order(scene) == 3);
  scene.generators = {model::Rotation{.fold = 3, .axis = z, .point = Eigen::Vector3d(500, 0, 0)}};
  CHECK(order(scene) == 3);
  const std::string missed = given_error(
      scene, model::Rotation{.fold = 3, .axis = z, .point = Eigen::Vector3d(505, 0, 0)});
  CHECK_THAT(missed, StartsWith("small.obj: design.symmetry[0]: the 3-fold rotation about the axis "
                                "(0, 0, 1) through (505, 0, 0) does not map the curves onto "
                                "themselves: the rod misses what it should become by "));
  CHECK_THAT(missed, Contains("where 0.1 % is allowed"));
}

TEST_CASE("a symmetry that the target lacks is refused with its misfit") {
  CHECK_THAT(given_error(trefoil_scene(60), model::Rotation{.fold = 4, .axis = z}),
             Contains("4-fold") && Contains("misses what it should become by"));
  CHECK_THAT(given_error(trefoil_scene(60), model::Reflection{.normal = z}),
             Contains("the reflection with normal (0, 0, 1)"));
}

TEST_CASE("a symmetry of the curves alone is said not to be one of the scene") {
  model::Scene scene = detected_ellipse();
  scene.rules.forbidden = {{.rod = 0, .from = 0, .to = 0.1 * scene.structure.rods[0].length()}};
  CHECK_THAT(given_error(scene, model::Rotation{.fold = 2, .axis = z}),
             Contains("is not a symmetry of the scene: it "));
}

TEST_CASE("supports, loads, weights and rules have to be symmetric too") {
  model::Scene scene = detected_ellipse();
  const double length = scene.structure.rods[0].length();
  const model::Reflection across_x{.normal = Eigen::Vector3d::UnitX()};
  REQUIRE(order(scene) == 8);
  REQUIRE(given_error(scene, across_x) == "no error");
  SECTION("pins") {
    scene.structure.pins = {{.rod = 0, .vertex = 0}};
    CHECK(order(scene) == 4);  // the planes through the vertex, and the axis between them
    CHECK_THAT(given_error(scene, across_x),
               Contains("it does not keep the pins: vertex 0 of the rod"));
    scene.structure.pins.push_back({.rod = 0, .vertex = 20});
    CHECK(order(scene) == 8);
    scene.structure.pins[1].axes = {true, true, false};
    CHECK(order(scene) == 4);
  }
  SECTION("loads") {
    scene.structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 20}};
    scene.structure.point_loads = {{.rod = 0, .s = length / 4, .force = -z}};
    CHECK(order(scene) == 2);
    scene.structure.point_loads.push_back({.rod = 0, .s = 3 * length / 4, .force = -z});
    CHECK(order(scene) == 4);
    CHECK_THAT(given_error(scene, model::Reflection{.normal = z}),
               Contains("it does not keep loads[0]"));
  }
  SECTION("gravity") {
    scene.structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 20}};
    scene.structure.line_loads = {{.rod = 0, .force_per_length = -z}};
    CHECK(order(scene) == 4);
  }
  SECTION("weights") {
    scene.target.weights[0].segment(3, 8).setConstant(5);
    CHECK(order(scene) == 2);
    CHECK_THAT(given_error(scene, across_x), Contains("it does not keep the weights of the rod"));
  }
  SECTION("forbidden arcs") {
    scene.rules.forbidden = {{0, 0.05 * length, 0.15 * length}};
    CHECK(order(scene) == 2);
    CHECK_THAT(given_error(scene, across_x), Contains("it brings a forbidden arc of the rod"));
    scene.rules.forbidden.push_back({0, 0.35 * length, 0.45 * length});
    CHECK(order(scene) == 4);
  }
  SECTION("sections that are not round") {
    scene.structure.rods[0].section.EI2 *= 2;
    CHECK(order(scene) == 1);
    CHECK_THAT(given_error(scene, across_x), Contains("it does not know the sides of the rod"));
  }
  SECTION("a twist has a hand") {
    scene.structure.rods[0].closing_angle = std::numbers::pi;
    CHECK(order(scene) == 4);
    CHECK_THAT(given_error(scene, across_x), Contains("it would twist the rod the other way"));
  }
}

TEST_CASE("pairs of rods that cables may join have to be symmetric") {
  std::vector<geometry::Polyline> circles;
  for (const double height : {-10.0, 0.0, 10.0}) {
    geometry::Polyline one = curves::ellipse(30, 20, 24);
    one.points.row(2).array() += height;
    circles.push_back(one);
  }
  model::Scene scene = scene_of(circles);
  scene.design.symmetry = SymmetryUse::detect;
  CHECK(order(scene) == 8);
  scene.rules.pairs = {{0, 1}};
  CHECK(order(scene) == 4);
  CHECK_THAT(given_error(scene, model::Reflection{.normal = z}),
             Contains("it does not keep the pairs of rods"));
  scene.rules.pairs = {{0, 1}, {1, 2}};
  CHECK(order(scene) == 8);
}

TEST_CASE("symmetries are offered in one line to those who said nothing of them") {
  std::vector<std::string> lines;
  const pipeline::RunOptions options{.log = [&](core::Level level, std::string_view line) {
    if (level == core::Level::info && line.starts_with("the target has")) lines.emplace_back(line);
  }};
  model::Scene scene = trefoil_scene(36);
  scene.build.length_error = scene.build.attachment_error = 0;  // which take most of the time
  SECTION("nothing said") {
    designed(scene, options);
    REQUIRE(lines.size() == 1);
    CHECK_THAT(lines[0],
               StartsWith("the target has a 3-fold rotation about (0, 0, 1) and 3 further "
                          "axes of rotation: with symmetry = \"detect\""));
  }
  SECTION("said") {
    scene.design.symmetry = GENERATE(SymmetryUse::none, SymmetryUse::detect);
    designed(scene, options);
    CHECK(lines.empty());
  }
  SECTION("none there") {
    Eigen::Matrix3Xd points = scene.target.points[0];
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const double t =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points.cols());
      points.col(i) += Eigen::Vector3d(std::cos(2 * t), std::sin(5 * t), std::cos(t + 1));
    }
    retarget(scene, 0, points);
    designed(scene, options);
    CHECK(lines.empty());
  }
}
