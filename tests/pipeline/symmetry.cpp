// Symmetries that a scene gives, or asks to have found: verified, offered, and kept by the cables.
#include <numbers>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/springs/cable.hpp>
#include <tencer/symmetry/orbit.hpp>

#include "scenes.hpp"

using namespace tencer;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();

int order(const io::Scene& scene) {
  const auto ready = prepared_of(scene);
  return ready.symmetry ? ready.symmetry->order() : 1;
}

// An ellipse in the plane z = 0: two mirror planes and the plane itself.
io::Scene detected_ellipse() {
  io::Scene scene = ellipse_scene(40);
  scene.design.symmetry = "detect";
  return scene;
}

std::string given_error(io::Scene scene, io::SymmetryGenerator generator) {
  scene.design.symmetry = "given";
  scene.design.generators = {std::move(generator)};
  const auto result = pipeline::prepare(scene);
  return result ? "no error" : result.error().text();
}

// Whether the design's cables are mapped onto each other, and orbits have the same tension.
void check_symmetric(const io::Scene& scene, const io::Design& design) {
  const auto ready = prepared_of(scene);
  const auto& group = ready.symmetry;
  REQUIRE(group);
  const double length = ready.units.scale.length;
  const auto end = [&](const io::CableEnd& at) -> springs::End {
    if (at.anchor >= 0) return springs::AtAnchor{at.anchor};
    return springs::OnRod{at.rod, at.s / length};
  };
  std::vector<springs::Cable> cables;
  for (const auto& cable : design.cables)
    cables.push_back({.a = end(cable.a), .b = end(cable.b), .stiffness = cable.tension});
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
  io::Scene scene = trefoil_scene(60);
  const io::Design without = designed(scene);
  CHECK(without.status == io::DesignStatus::complete);

  scene.design.symmetry = "given";
  scene.design.generators = {io::Rotation{.fold = 3, .axis = z}};
  CHECK(order(scene) == 3);
  const io::Design with = designed(scene);
  CHECK(with.status == io::DesignStatus::complete);
  CHECK(with.cables.size() % 3 == 0);
  check_symmetric(scene, with);
  check_consistent(with);
}

TEST_CASE("two rods with many symmetries are held by few orbits") {
  const auto knots = curves::twin_trefoils(27, 10.8, 72);
  io::Scene scene = scene_of({knots.begin(), knots.end()});
  scene.design.rod_pairs = {{0, 1}};
  scene.design.max_error = 5.4;
  scene.design.symmetry = "detect";
  CHECK(order(scene) == 12);
  const io::Design design = designed(scene);
  CHECK(design.status == io::DesignStatus::complete);
  check_symmetric(scene, design);
}

TEST_CASE("generators make a group, and what is found is the same") {
  io::Scene scene = trefoil_scene(60);
  CHECK(order(scene) == 1);
  scene.design.symmetry = "given";
  scene.design.generators = {io::Rotation{.fold = 3, .axis = z},
                             io::Rotation{.fold = 2, .axis = Eigen::Vector3d::UnitY()}};
  CHECK(order(scene) == 6);
  scene.design.symmetry = "detect";
  CHECK(order(scene) == 6);
  scene.design.symmetry = "none";
  CHECK(order(scene) == 1);
}

TEST_CASE("an axis is through the rods' centroid, or where its point says") {
  io::Scene scene = trefoil_scene(60);
  for (auto point : scene.rods[0].target.points.colwise()) point += Eigen::Vector3d(500, 0, 30);
  scene.design.symmetry = "given";
  scene.design.generators = {io::Rotation{.fold = 3, .axis = 2 * z}};
  CHECK(order(scene) == 3);
  scene.design.generators = {
      io::Rotation{.fold = 3, .axis = z, .point = Eigen::Vector3d(500, 0, 0)}};
  CHECK(order(scene) == 3);
  const std::string missed =
      given_error(scene, io::Rotation{.fold = 3, .axis = z, .point = Eigen::Vector3d(505, 0, 0)});
  CHECK_THAT(missed, StartsWith("small.obj: design.symmetry[0]: the 3-fold rotation about the axis "
                                "(0, 0, 1) through (505, 0, 0) does not map the curves onto "
                                "themselves: rod 0 misses what it should become by "));
  CHECK_THAT(missed, Contains("where 0.1 % is allowed"));
}

TEST_CASE("a symmetry that the target lacks is refused with its misfit") {
  CHECK_THAT(given_error(trefoil_scene(60), io::Rotation{.fold = 4, .axis = z}),
             Contains("4-fold") && Contains("misses what it should become by"));
  CHECK_THAT(given_error(trefoil_scene(60), io::Reflection{.normal = z}),
             Contains("the reflection with normal (0, 0, 1)"));
}

TEST_CASE("supports, loads, weights and rules have to be symmetric too") {
  io::Scene scene = detected_ellipse();
  const double length = geometry::edge_lengths(scene.rods[0].target).sum();
  const io::Reflection across_x{.normal = Eigen::Vector3d::UnitX()};
  REQUIRE(order(scene) == 8);
  REQUIRE(given_error(scene, across_x) == "no error");
  SECTION("pins") {
    scene.pinned = {{.rod = 0, .vertex = 0}};
    CHECK(order(scene) == 4);  // the planes through the vertex, and the axis between them
    CHECK_THAT(given_error(scene, across_x),
               Contains("it does not keep the pins: vertex 0 of rod 0"));
    scene.pinned.push_back({.rod = 0, .vertex = 20});
    CHECK(order(scene) == 8);
    scene.pinned[1].axes = {true, true, false};
    CHECK(order(scene) == 4);
  }
  SECTION("loads") {
    scene.pinned = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 20}};
    scene.point_loads = {{.rod = 0, .s = length / 4, .force = -z}};
    CHECK(order(scene) == 2);
    scene.point_loads.push_back({.rod = 0, .s = 3 * length / 4, .force = -z});
    CHECK(order(scene) == 4);
    CHECK_THAT(given_error(scene, io::Reflection{.normal = z}),
               Contains("it does not keep load 0"));
  }
  SECTION("gravity") {
    scene.pinned = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 20}};
    scene.line_loads = {{.rod = 0, .force_per_length = -z}};
    CHECK(order(scene) == 4);
  }
  SECTION("weights") {
    scene.rods[0].weights.segment(3, 8).setConstant(5);
    CHECK(order(scene) == 2);
    CHECK_THAT(given_error(scene, across_x), Contains("it does not keep the weights of rod 0"));
  }
  SECTION("forbidden arcs") {
    scene.rods[0].forbidden_arcs = {{0.05 * length, 0.15 * length}};
    CHECK(order(scene) == 2);
    CHECK_THAT(given_error(scene, across_x), Contains("it brings a forbidden arc of rod 0"));
    scene.rods[0].forbidden_arcs.push_back({0.35 * length, 0.45 * length});
    CHECK(order(scene) == 4);
  }
  SECTION("sections that are not round") {
    scene.rods[0].section.EI[1] *= 2;
    CHECK(order(scene) == 1);
    CHECK_THAT(given_error(scene, across_x), Contains("it does not know the sides of rod 0"));
  }
  SECTION("a twist has a hand") {
    scene.rods[0].closing_angle = std::numbers::pi;
    CHECK(order(scene) == 4);
    CHECK_THAT(given_error(scene, across_x), Contains("it would twist rod 0 the other way"));
  }
}

TEST_CASE("pairs of rods that cables may join have to be symmetric") {
  std::vector<geometry::Polyline> circles;
  for (const double height : {-10.0, 0.0, 10.0}) {
    geometry::Polyline one = curves::ellipse(30, 20, 24);
    one.points.row(2).array() += height;
    circles.push_back(one);
  }
  io::Scene scene = scene_of(circles);
  scene.design.symmetry = "detect";
  CHECK(order(scene) == 8);
  scene.design.rod_pairs = {{0, 1}};
  CHECK(order(scene) == 4);
  CHECK_THAT(given_error(scene, io::Reflection{.normal = z}),
             Contains("it does not keep the pairs of rods"));
  scene.design.rod_pairs = {{0, 1}, {1, 2}};
  CHECK(order(scene) == 8);
}

TEST_CASE("symmetries are offered in one line to those who said nothing of them") {
  std::vector<std::string> lines;
  const pipeline::DesignOptions options{.log = [&](core::Level level, std::string_view line) {
    if (level == core::Level::info && line.starts_with("the target has")) lines.emplace_back(line);
  }};
  io::Scene scene = trefoil_scene(36);
  SECTION("nothing said") {
    designed(scene, options);
    REQUIRE(lines.size() == 1);
    CHECK_THAT(lines[0],
               StartsWith("the target has a 3-fold rotation about (0, 0, 1) and 3 further "
                          "axes of rotation: with symmetry = \"detect\""));
  }
  SECTION("said") {
    scene.design.symmetry = GENERATE(as<std::string>{}, "none", "detect");
    designed(scene, options);
    CHECK(lines.empty());
  }
  SECTION("none there") {
    geometry::Polyline& target = scene.rods[0].target;
    for (int i = 0; i < target.vertices(); ++i) {
      const double t = 2 * std::numbers::pi * i / target.vertices();
      target.points.col(i) += Eigen::Vector3d(std::cos(2 * t), std::sin(5 * t), std::cos(t + 1));
    }
    designed(scene, options);
    CHECK(lines.empty());
  }
}
