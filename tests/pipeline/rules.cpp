// What a scene says of cables is kept to, and rules that leave none are named.
#include "scenes.hpp"

using namespace tencer;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

// An open rod in the box of eight anchors.
model::Scene helix_scene() {
  model::Scene scene = scene_of({curves::helix(50, 33, 1.5, 20)});
  scene.structure.anchors.resize(3, 8);
  for (int i = 0; i < 8; ++i)
    scene.structure.anchors.col(i) << (i & 1 ? 60 : -60), (i & 2 ? 60 : -60), (i & 4 ? 90 : -40);
  return scene;
}

// Two ellipses, one through the other.
model::Scene linked_rings() {
  geometry::Polyline ring = curves::ellipse(30, 20, 16);
  geometry::Polyline other = ring;
  for (auto point : other.points.colwise()) point = Eigen::Vector3d(point.x() + 27, 1, point.y());
  return scene_of({ring, other});
}

const springs::OnRod& on_rod(const springs::End& end) { return std::get<springs::OnRod>(end); }

bool on_arc(double s, const model::Arc& arc) {
  return arc.from <= arc.to ? s > arc.from && s < arc.to : s > arc.from || s < arc.to;
}

}  // namespace

TEST_CASE("cables join only the pairs of rods that are named") {
  model::Scene scene = linked_rings();
  scene.rules.pairs = {{0, 1}};
  const model::Design design = designed(scene);
  REQUIRE_FALSE(design.structure.cables.empty());
  for (const auto& cable : design.structure.cables)
    CHECK(on_rod(cable.a).rod + on_rod(cable.b).rod == 1);
  check_consistent(design);
}

TEST_CASE("no cable ends in a forbidden arc or is too long") {
  // Without rules, one or two cables draw the long sides of the ellipse together; they are 50
  // apart.
  model::Scene scene = ellipse_scene();
  const double length = scene.structure.rods[0].length();
  const double vertex_21 = arc_lengths(scene.structure)[0].knots()[21];
  const model::Arc long_side{0, 0.22 * length, 0.29 * length};
  const model::Arc across_the_seam{0, 0.95 * length, 0.03 * length};
  scene.rules.forbidden = {long_side, across_the_seam, {0, vertex_21, vertex_21}};
  scene.rules.max_cable_length = 49;
  const model::Design design = designed(scene);
  REQUIRE_FALSE(design.structure.cables.empty());
  for (const auto& [cable_length, tension] : design.built) CHECK(cable_length <= 49 * (1 + 1e-9));
  for (const auto& cable : design.structure.cables)
    for (const springs::End& end : {cable.a, cable.b}) {
      CHECK_FALSE(on_arc(on_rod(end).s, long_side));
      CHECK_FALSE(on_arc(on_rod(end).s, across_the_seam));
      CHECK(std::abs(on_rod(end).s - vertex_21) > 0);
    }
  check_consistent(design);
}

TEST_CASE("anchors take cables only where external cables are allowed") {
  model::Scene scene = helix_scene();
  const model::Design with = designed(scene);
  CHECK(std::ranges::any_of(with.structure.cables, model::is_external));
  check_consistent(with);

  scene.rules.external = false;
  scene.design.max_error = 30;  // closer nothing holds it without
  const model::Design without = designed(scene);
  CHECK(std::ranges::none_of(without.structure.cables, model::is_external));
  check_consistent(without);
}

TEST_CASE("rules that leave no cable are named by their key") {
  model::Scene scene = ellipse_scene(12);
  scene.source = "folder/scene.toml";
  SECTION("longest_cable") {
    scene.rules.max_cable_length = 0.1;
    CHECK_THAT(error_of(scene), StartsWith("folder/scene.toml: design.longest_cable: no cables"));
  }
  SECTION("rod_pairs") {
    scene.rules.pairs.emplace();
    CHECK_THAT(error_of(scene), StartsWith("folder/scene.toml: design.rod_pairs: no cables"));
  }
  SECTION("forbidden arcs") {
    scene.rules.forbidden = {{0, 0.0, scene.structure.rods[0].length()}};
    CHECK_THAT(error_of(scene), StartsWith("folder/scene.toml: design.forbidden_arcs: no cables"));
  }
  SECTION("forbidden vertices") {
    const geometry::ArcLength along = arc_lengths(scene.structure)[0];
    for (int i = 0; i < 12; ++i)
      scene.rules.forbidden.push_back({0, along.knots()[i], along.knots()[i]});
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
  pipeline::RunOptions options;
  std::erase_if(options.backends, [](const auto& backend) { return backend.name == "ipopt"; });
  model::Scene scene = ellipse_scene(12);
  scene.design.optimizer = model::Optimizer::ipopt;
  const std::string error = error_of(scene, options);
  CHECK_THAT(error, StartsWith("small.obj: design.optimizer: optimizer \"ipopt\""));
  CHECK_THAT(error, !Contains("has: ipopt"));
  for (const auto& backend : options.backends) CHECK_THAT(error, Contains(backend.name));
}

TEST_CASE("an optimizer that is not used need not be there") {
  pipeline::RunOptions options;
  options.backends.clear();
  CHECK(pipeline::design(ellipse_scene(12), options));
}

TEST_CASE("anchors must enclose the target") {
  model::Scene scene = helix_scene();
  SECTION("around something else") {
    scene.structure.anchors.row(0).array() += 50;
    CHECK_THAT(error_of(scene), StartsWith("small.obj: anchors: their convex hull must enclose"));
  }
  SECTION("in a plane") {
    scene.structure.anchors.row(2).setZero();
    CHECK_THAT(error_of(scene), Contains("these 8 enclose nothing"));
  }
  SECTION("not where no cable goes to them") {
    scene.structure.anchors.row(0).array() += 50;
    scene.rules.external = false;
    scene.design.max_error = 30;  // closer nothing holds it
    CHECK(error_of(scene) == "no error");
  }
}

TEST_CASE("an anchor on a vertex is no place for a cable") {
  model::Scene scene = helix_scene();
  scene.structure.anchors.conservativeResize(3, 9);
  scene.structure.anchors.col(8) = scene.target.points[0].col(4);
  CHECK_THAT(error_of(scene), StartsWith("small.obj: vertex 4 of rods[0] and anchors[8] coincide"));
}
