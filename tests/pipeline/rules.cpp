// What a scene says of cables is kept to, and rules that leave none are named.
#include "scenes.hpp"

using namespace tencer;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

// An open rod in the box of eight anchors.
io::Scene helix_scene() {
  io::Scene scene = scene_of({curves::helix(50, 33, 1.5, 20)});
  scene.anchors.resize(3, 8);
  for (int i = 0; i < 8; ++i)
    scene.anchors.col(i) << (i & 1 ? 60 : -60), (i & 2 ? 60 : -60), (i & 4 ? 90 : -40);
  return scene;
}

// Two ellipses, one through the other.
io::Scene linked_rings() {
  geometry::Polyline ring = curves::ellipse(30, 20, 16);
  geometry::Polyline other = ring;
  for (auto point : other.points.colwise()) point = Eigen::Vector3d(point.x() + 27, 1, point.y());
  return scene_of({ring, other});
}

bool on_arc(const io::CableEnd& end, double from, double to) {
  return end.rod >= 0 && (from <= to ? end.s > from && end.s < to : end.s > from || end.s < to);
}

}  // namespace

TEST_CASE("cables join only the pairs of rods that are named") {
  io::Scene scene = linked_rings();
  scene.design.rod_pairs = {{0, 1}};
  const io::Design design = designed(scene);
  REQUIRE_FALSE(design.cables.empty());
  for (const auto& cable : design.cables) CHECK(cable.a.rod + cable.b.rod == 1);
  check_consistent(design);
}

TEST_CASE("no cable ends in a forbidden arc or is too long") {
  // Without rules, one or two cables draw the long sides of the ellipse together; they are 50
  // apart.
  io::Scene scene = ellipse_scene();
  const double length = geometry::edge_lengths(scene.rods[0].target).sum();
  const io::Arc long_side{0.22 * length, 0.29 * length};
  const io::Arc across_the_seam{0.95 * length, 0.03 * length};
  scene.rods[0].forbidden_arcs = {long_side, across_the_seam};
  scene.rods[0].forbidden_vertices = {21};
  scene.design.longest_cable = 49;
  const io::Design design = designed(scene);
  REQUIRE_FALSE(design.cables.empty());
  const double vertex_21 = design.rods[0].rest_lengths.head(21).sum();
  for (const auto& cable : design.cables) {
    CHECK(cable.length <= 49 * (1 + 1e-9));
    for (const io::CableEnd& end : {cable.a, cable.b}) {
      CHECK_FALSE(on_arc(end, long_side.from, long_side.to));
      CHECK_FALSE(on_arc(end, across_the_seam.from, across_the_seam.to));
      CHECK(std::abs(end.s - vertex_21) > 0);
    }
  }
  check_consistent(design);
}

TEST_CASE("anchors take cables only where external cables are allowed") {
  io::Scene scene = helix_scene();
  const io::Design with = designed(scene);
  CHECK(std::ranges::any_of(with.cables, is_external));
  check_consistent(with);

  scene.design.external = false;
  const io::Design without = designed(scene);
  CHECK(std::ranges::none_of(without.cables, is_external));
  check_consistent(without);
}

TEST_CASE("rules that leave no cable are named by their key") {
  io::Scene scene = ellipse_scene(12);
  scene.source = "folder/scene.toml";
  SECTION("longest_cable") {
    scene.design.longest_cable = 0.1;
    CHECK_THAT(error_of(scene), StartsWith("folder/scene.toml: design.longest_cable: no cables"));
  }
  SECTION("rod_pairs") {
    scene.design.rod_pairs.emplace();
    CHECK_THAT(error_of(scene), StartsWith("folder/scene.toml: design.rod_pairs: no cables"));
  }
  SECTION("forbidden arcs") {
    scene.rods[0].forbidden_arcs = {{0, geometry::edge_lengths(scene.rods[0].target).sum()}};
    CHECK_THAT(error_of(scene), StartsWith("folder/scene.toml: design.forbidden_arcs: no cables"));
  }
  SECTION("forbidden vertices") {
    for (int i = 0; i < 12; ++i) scene.rods[0].forbidden_vertices.push_back(i);
    CHECK_THAT(error_of(scene),
               StartsWith("folder/scene.toml: design.forbidden_vertices: no cables"));
  }
}

TEST_CASE("a rod without room for a cable") {
  const geometry::Polyline rod{(Eigen::Matrix3Xd(3, 2) << 0, 1, 0, 0, 0, 0).finished(), false};
  CHECK(error_of(scene_of({rod})) ==
        "small.obj: no cable is possible: the vertices are all neighbours on their rod, or held in "
        "place");
}

TEST_CASE("an optimizer that was left out is named, with those that are there") {
  pipeline::DesignOptions options;
  std::erase_if(options.backends, [](const auto& backend) { return backend.name == "ipopt"; });
  io::Scene scene = ellipse_scene(12);
  scene.design.optimizer = "ipopt";
  const std::string error = error_of(scene, options);
  CHECK_THAT(error, StartsWith("small.obj: design.optimizer: optimizer \"ipopt\""));
  CHECK_THAT(error, !Contains("has: ipopt"));
  for (const auto& backend : options.backends) CHECK_THAT(error, Contains(backend.name));
}

TEST_CASE("anchors must enclose the target") {
  io::Scene scene = helix_scene();
  SECTION("around something else") {
    scene.anchors.row(0).array() += 50;
    CHECK_THAT(error_of(scene), StartsWith("small.obj: anchors: their convex hull must enclose"));
  }
  SECTION("in a plane") {
    scene.anchors.row(2).setZero();
    CHECK_THAT(error_of(scene), Contains("these 8 enclose nothing"));
  }
  SECTION("not where no cable goes to them") {
    scene.anchors.row(0).array() += 50;
    scene.design.external = false;
    CHECK(error_of(scene) == "no error");
  }
}

TEST_CASE("an anchor on a vertex is no place for a cable") {
  io::Scene scene = helix_scene();
  scene.anchors.conservativeResize(3, 9);
  scene.anchors.col(8) = scene.rods[0].target.points.col(4);
  CHECK_THAT(error_of(scene), StartsWith("small.obj: vertex 4 of rods[0] and anchors[8] coincide"));
}
