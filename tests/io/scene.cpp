#include <catch2/catch.hpp>
#include <numbers>
#include <tencer/curves/analytic.hpp>
#include <tencer/io/curve.hpp>
#include <tencer/io/scene.hpp>
#include <tuple>

#include "curves_folder.hpp"

using namespace tencer;
using namespace tencer::io;
using Catch::Matchers::Contains;
using std::numbers::pi;

TEST_CASE("a rod drawn with a few points") {
  const Curves folder;
  const model::Scene scene = folder.scene(R"(
[[rod]]
spline = [[0, 0, 0], [10, 5, 0], [20, 0, 5]]
[[rod]]
spline = [[0, 20, 0], [10, 25, 0], [20, 20, 5], [0, 20, 0]]
vertices = 60
closed = true
)");
  REQUIRE(scene.structure.rods.size() == 2);
  const geometry::Polyline open = target_curve(scene, 0);
  CHECK_FALSE(open.closed);
  REQUIRE(open.vertices() == 100);
  CHECK(open.points.col(0) == Eigen::Vector3d(0, 0, 0));
  CHECK((open.points.col(99) - Eigen::Vector3d(20, 0, 5)).norm() < 1e-9);
  // Halfway point of the drawing lies on the curve, between vertices.
  CHECK((open.points.colwise() - Eigen::Vector3d(10, 5, 0)).colwise().norm().minCoeff() < 0.15);
  CHECK(target_curve(scene, 1).closed);
  CHECK(target_curve(scene, 1).vertices() == 60);
}

TEST_CASE("a frame's corners are anchors about all rods") {
  const Curves folder;
  const std::string two = "[[rod]]\ncurve = 'ring.obj'\n[[rod]]\ncurve = 'line.csv'\n";
  const model::Scene cube = folder.scene("frame = {shape = 'cube', margin = 2}\n" + two);
  const Eigen::Matrix3Xd& corners = cube.structure.anchors;
  REQUIRE(corners.cols() == 8);
  // Rods reach from 0 to 11 along x and from 0 to 4 along y, at z = 0.
  CHECK(corners.rowwise().minCoeff() == Eigen::Vector3d(-2, -5.5, -7.5));
  CHECK(corners.rowwise().maxCoeff() == Eigen::Vector3d(13, 9.5, 7.5));
  CHECK(folder.scene("frame = {shape = 'tetrahedron'}\n" + two).structure.anchors.cols() == 4);
  const model::Scene square = folder.scene("planar = true\nframe = {shape = 'cube'}\n" + two);
  REQUIRE(square.structure.anchors.cols() == 4);
  CHECK(square.structure.anchors.row(2).isZero(0));
  // The default margin is a tenth of the diagonal.
  CHECK(square.structure.anchors.row(0).minCoeff() == Approx(-0.1 * std::hypot(11, 4)));
}

TEST_CASE("a scene of one line has defaults for all else") {
  const Curves folder;
  const model::Scene scene = folder.scene("rod = [{curve = 'ring.obj'}]");
  CHECK(scene.name == "s");
  CHECK(scene.length_unit == "cm");
  CHECK(scene.force_unit == "N");
  REQUIRE(scene.structure.rods.size() == 1);
  CHECK(target_curve(scene, 0).closed);
  CHECK(target_curve(scene, 0).vertices() == 4);
  CHECK(scene.target.weights[0] == Eigen::VectorXd::Ones(4));
  const der::Section& section = scene.structure.rods[0].section;
  CHECK(section.EA == Approx(4e6 * pi * 0.016 * 0.016));
  CHECK(section.EI1 == Approx(4e6 * pi * std::pow(0.016, 4) / 4));
  CHECK(section.EI2 == section.EI1);
  CHECK(section.GJ == Approx(section.EI1 / 1.3));
  CHECK(scene.source == (folder / "s.toml").string());
  CHECK(scene.structure.anchors.cols() == 0);
  CHECK(scene.structure.pins.empty());
  CHECK_FALSE(scene.structure.planar);
  CHECK(scene.design.method == model::Method::force_balance);
  CHECK(scene.design.optimizer == model::Optimizer::gauss_newton);
  CHECK(scene.design.hessian == model::SecondDerivatives::gauss_newton);
  CHECK(scene.design.max_error == 1.0);
  CHECK_FALSE(scene.rules.pairs);
  CHECK(std::isinf(scene.rules.max_cable_length));
  CHECK(scene.rules.external);
  CHECK(scene.design.sparsity_weights.front() == 0);
  CHECK(scene.design.spring_stiffness == 100);
  CHECK(scene.design.greedy_threshold == 5e-6);
}

TEST_CASE("a rod is of its material, and its section can say otherwise") {
  const Curves folder;
  const model::Scene scene = folder.scene(R"(
length_unit = "mm"
gravity = [0, 0, -10]
[[rod]]
curve = "ring.obj"
material = "spruce"
section = {radius = 0.1}
[[rod]]
curve = "line.csv"
section = {radius = 0.1, youngs_modulus = 50000, density = 1000}
)");
  const auto& [rods, materials] = std::tie(scene.structure.rods, scene.structure.materials);
  REQUIRE(materials.size() == 2);
  CHECK(materials[0].name == "spruce");
  CHECK(rods[0].section.EA == Approx(11e3 * pi * 0.01));
  CHECK(std::get<der::Circle>(rods[0].section.shape).radius == 0.1);
  CHECK(materials[1].name == "glass fibre");
  CHECK(materials[1].youngs_modulus == Approx(50e9));
  CHECK(*materials[1].density == 1000);
  CHECK(rods[1].section.EA == Approx(50e3 * pi * 0.01));
  // Newtons a millimetre: 450 kg/m^3, 10 m/s^2.
  REQUIRE(scene.structure.line_loads.size() == 2);
  CHECK(scene.structure.line_loads[0].force_per_length.z() == Approx(-450 * pi * 1e-8 * 10 / 1e3));

  const auto ash = read_scene(folder.put("s.toml", "rod = [{family = 'circle'}]"),
                              {.material = *model::find_material("ash")});
  REQUIRE(ash);
  CHECK(ash->structure.materials[0].name == "ash");
  // A ring of radius 25 cm: 0.8 of a strain of 0.5 %, and the chords bend a little more.
  CHECK(std::get<der::Circle>(ash->structure.rods[0].section.shape).radius == Approx(0.099));
}

TEST_CASE("a bare curve makes the same scene as a scene that only names it") {
  const Curves folder;
  const model::Scene named = folder.scene("name = 'both'\n[[rod]]\ncurve = 'both.obj'\n");
  const auto bare = scene_of_curves(read_curves(folder / "both.obj").value(), folder / "both.obj");
  REQUIRE(bare);
  CHECK(bare->name == "both");
  REQUIRE(bare->structure.rods.size() == 2);
  for (int i = 0; i < 2; ++i) {
    const der::Section& here = bare->structure.rods[i].section;
    const der::Section& there = named.structure.rods[i].section;
    CHECK(bare->target.points[i] == named.target.points[i]);
    CHECK(bare->structure.rods[i].closed == named.structure.rods[i].closed);
    CHECK(here.EA == there.EA);
    CHECK(here.EI1 == there.EI1);
    CHECK(here.EI2 == there.EI2);
    CHECK(here.GJ == there.GJ);
    CHECK(bare->target.weights[i] == named.target.weights[i]);
  }
  // All rods are of one stock: the longest rod sets the radius.
  CHECK(bare->structure.rods[0].section.EA == bare->structure.rods[1].section.EA);
  CHECK(folder.local(scene_of_curves({}, folder / "x.obj").error().text()) ==
        "x.obj: holds no curves");
}

TEST_CASE("corners are rounded on request") {
  const Curves folder;
  const std::string ring = "length_unit = 'mm'\n[[rod]]\ncurve = 'ring.obj'\n";
  const auto length_of = [](const model::Scene& scene) {
    return geometry::edge_lengths(target_curve(scene, 0)).sum();
  };
  const double round = 4 * 2 + 2 * pi;
  const model::Scene smooth = folder.scene(ring + "smooth = 1\n");
  CHECK(length_of(smooth) == Approx(round).epsilon(0.02));
  CHECK(target_curve(smooth, 0).vertices() > 40);
  REQUIRE(smooth.notes.size() == 1);
  CHECK_THAT(smooth.notes[0],
             Contains("4 bends sharper than a radius of 1 mm are rounded, which moves the curve by "
                      "up to 0.4") &&
                 Contains("at arc length 0 mm, (0, 0, 0), and 3 more"));
  CHECK(target_curve(folder.scene(ring + "smooth = 1\nvertices = 60\n"), 0).vertices() == 60);
  CHECK_THAT(folder.error(ring + "smooth = 3\n"),
             Contains("s.toml:4: rod[0].smooth: there is no room for a radius of 3 mm at arc "
                      "length") &&
                 Contains("take a smaller one"));
  // What the program says holds for scenes and bare curves, in the scene's unit.
  const auto said = read_any_scene(folder.put("s.toml", ring + "smooth = 3\n"), {.smooth = 1});
  REQUIRE(said);
  CHECK(length_of(*said) == Approx(round).epsilon(0.02));
  const auto bare = read_any_scene(folder / "ring.obj", {.length_unit = "in", .smooth = 2.54});
  REQUIRE(bare);
  CHECK(length_of(*bare) == Approx(2.54 * round).epsilon(0.02));
  const auto none = read_any_scene(folder / "ring.obj", {.smooth = 3});
  REQUIRE_FALSE(none);
  CHECK_THAT(none.error().text(), Contains("ring.obj: --smooth: there is no room for a radius"));
}

TEST_CASE("everything a scene can say is read") {
  const Curves folder;
  const model::Scene scene = folder.scene(R"(
name = "all"
length_unit = "mm"
force_unit = "kN"
planar = true
anchors = [[20, 0, 0], [0, 20.5, 0]]
pinned = [{rod = 1, vertex = 2}, {rod = 0, vertex = 0, axes = "xz"}]

[[rod]]
curve = "both.obj"
closed = true
index = 0
vertices = 8
section = {shape = "circle", radius = 0.5, youngs_modulus = 40, poisson = 0.25}

[[rod]]
curve = "both.obj"
index = 1
closed = false
section = {EA = 3, EI = [2, 1], GJ = 0.5}

[[rod]]
family = "circle"
parameters = {radius = 30}
vertices = 6
section = {EA = 3, EI = 2, GJ = 0.5}

[design]
method = "dense-springs"
optimizer = "ipopt"
hessian = "exact"
max_error = 0.5
rod_pairs = [[1, 0], [2, 2]]
external = false
longest_cable = 7
sparsity_weights = [0, 0.5]
spring_stiffness = 10
greedy_threshold = 1e-5
weights = [{rod = 0, weight = 2}, {rod = 0, from = 14, to = 2, weight = 0}]
forbidden_arcs = [{rod = 1, from = 0, to = 1}, {rod = 0, from = 15, to = 1}]
forbidden_vertices = [{rod = 1, vertices = [2, 0]}]
)");
  CHECK(scene.name == "all");
  CHECK(scene.length_unit == "mm");
  CHECK(scene.force_unit == "kN");
  const model::Structure& structure = scene.structure;
  CHECK(structure.planar);
  CHECK(scene.target.planar);
  REQUIRE(structure.anchors.cols() == 2);
  CHECK(structure.anchors.col(1) == Eigen::Vector3d(0, 20.5, 0));
  REQUIRE(structure.pins.size() == 2);
  CHECK(structure.pins[0].rod == 1);
  CHECK(structure.pins[0].vertex == 2);
  CHECK(structure.pins[0].axes == std::array{true, true, true});
  CHECK(structure.pins[1].axes == std::array{true, false, true});
  REQUIRE(structure.rods.size() == 3);
  CHECK(structure.rods[0].vertices() == 8);
  CHECK(scene.target.points[0].col(1) == Eigen::Vector3d(2, 0, 0));
  CHECK(structure.rods[0].section.EA == Approx(40 * pi * 0.25));
  CHECK(structure.rods[0].section.GJ == Approx(16 * pi * std::pow(0.5, 4) / 2));
  CHECK(structure.rods[1].section.EI1 == 2);
  CHECK(structure.rods[1].section.EI2 == 1);
  CHECK(structure.rods[2].section.EI1 == 2);
  CHECK(structure.rods[2].section.EI2 == 2);
  CHECK(structure.rods[2].vertices() == 6);
  CHECK(scene.target.points[2].col(3).isApprox(Eigen::Vector3d(-30, 0, 0), 1e-8));
  const model::DesignSettings& design = scene.design;
  CHECK(design.method == model::Method::dense_springs);
  CHECK(design.optimizer == model::Optimizer::ipopt);
  CHECK(design.hessian == model::SecondDerivatives::exact);
  CHECK(design.max_error == 0.5);
  REQUIRE(scene.rules.pairs->size() == 2);
  CHECK(scene.rules.pairs->at(0).a == 0);
  CHECK(scene.rules.pairs->at(0).b == 1);
  CHECK(scene.rules.pairs->at(1).a == 2);
  CHECK(scene.rules.pairs->at(1).b == 2);
  CHECK_FALSE(scene.rules.external);
  CHECK(scene.rules.max_cable_length == 7);
  CHECK(design.sparsity_weights == std::vector<double>{0, 0.5});
  CHECK(design.spring_stiffness == 10);
  CHECK(design.greedy_threshold == 1e-5);
  // Vertices every 2 along 16; the arc goes through the seam.
  Eigen::VectorXd weights(8);
  weights << 0, 0, 2, 2, 2, 2, 2, 0;
  CHECK(scene.target.weights[0] == weights);
  // Two arcs, and two vertices: the last of the line and its first.
  const auto& forbidden = scene.rules.forbidden;
  REQUIRE(forbidden.size() == 4);
  CHECK(forbidden[0].rod == 1);
  CHECK(forbidden[0].to == 1);
  CHECK(forbidden[1].rod == 0);
  CHECK(forbidden[1].from == 15);
  for (const auto& [at, s] : {std::pair{2, structure.rods[1].length()}, {3, 0.0}}) {
    CHECK(forbidden[at].rod == 1);
    CHECK(forbidden[at].from == s);
    CHECK(forbidden[at].to == s);
  }
}

TEST_CASE("families in a scene are those of geometry") {
  const Curves folder;
  const model::Scene knot =
      folder.scene("rod = [{family = 'torus-knot', parameters = {p = 2, q = 3}}]");
  CHECK(knot.target.points[0] == curves::torus_knot(2, 3, 13.5, 5.4, 201).points);
  const model::Scene rings = folder.scene("rod = [{family = 'borromean-ellipses', vertices = 20}]");
  REQUIRE(rings.target.points.size() == 3);
  CHECK(rings.target.points[2] == curves::borromean_ellipses(6.5, 5, 20)[2].points);
  const model::Scene second = folder.scene("rod = [{family = 'twin-trefoils', index = 1}]");
  REQUIRE(second.target.points.size() == 1);
  CHECK(second.target.points[0] == curves::twin_trefoils(27, 10.8, 102)[1].points);
}

TEST_CASE("what rods are made of and carry is read") {
  const Curves folder;
  const model::Scene scene = folder.scene(R"(
length_unit = "cm"
force_unit = "mN"
gravity = [0, 0, -10]
loads = [{rod = 1, s = 0.5, force = [1, 2, 3]}]

[[rod]]
curve = "both.obj"
index = 0
section = {shape = "tube", outer_radius = 0.5, inner_radius = 0.3, youngs_modulus = 40, poisson = 0.25, density = 1000}
closing_turns = -1.5

[[rod]]
curve = "both.obj"
index = 1
section = {shape = "rectangle", width = 0.2, height = 0.6, youngs_modulus = 40, density = 1000}
director = [0, 0, 1]
rest = {curvature = 0.1}

[[rod]]
family = "circle"
parameters = {radius = 7}
vertices = 16
section = {EA = 3, EI = [2, 1], GJ = 0.5, mass_per_length = 0.25}
rest = {family = "circle", parameters = {radius = 7}, vertices = 12, director = [0, 0, -2]}
)");
  const auto& rods = scene.structure.rods;
  REQUIRE(rods.size() == 3);
  // pi E (a^4 - b^4) / 4 and pi G (a^4 - b^4) / 2 with G = E / 2.5
  const double fourth = std::pow(0.5, 4) - std::pow(0.3, 4);
  const der::Rod& tube = rods[0];
  CHECK(tube.section.EA == Approx(40 * pi * 0.16));
  CHECK(tube.section.EI1 == Approx(40 * pi / 4 * fourth));
  CHECK(tube.section.EI2 == tube.section.EI1);
  CHECK(tube.section.GJ == Approx(16 * pi / 2 * fourth));
  CHECK(*tube.closing_angle == Approx(-3 * pi));
  CHECK_FALSE(scene.directors[0]);
  CHECK(tube.rest_curvature.size() == 0);

  const der::Rod& strip = rods[1];
  CHECK(strip.section.EA == Approx(40 * 0.12));
  CHECK(strip.section.EI1 == Approx(40 * 0.2 * std::pow(0.6, 3) / 12));
  CHECK(strip.section.EI2 == Approx(40 * 0.6 * std::pow(0.2, 3) / 12));
  CHECK(*scene.directors[1] == Eigen::Vector3d::UnitZ());
  // Of two edges, 1 and sqrt(2) long: 0.1 per length over half of both, all towards the first axis.
  REQUIRE(strip.rest_curvature.cols() == 1);
  CHECK(strip.rest_curvature(0, 0) == Approx(2 * std::tan(0.05 * (1 + std::sqrt(2.0)) / 2)));
  CHECK(strip.rest_curvature(1, 0) == 0);

  // A polygon of twelve edges, its plane across the section's first axis: bent about that alone, as
  // much as the polygon, spread over sixteen vertices.
  const der::Rod& ring = rods[2];
  REQUIRE(ring.rest_curvature.cols() == 16);
  CHECK(ring.rest_curvature.row(0).norm() < 1e-9);
  for (const double bend : ring.rest_curvature.row(1))
    CHECK(bend == Approx(12 * 2 * std::tan(pi / 12) / 16));
  CHECK_FALSE(scene.directors[2]);

  // 1000 kg/m^3 of 1 cm^2 weigh 1 N/m at 10 m/s^2: 10 mN a cm.
  const auto& weights = scene.structure.line_loads;
  REQUIRE(weights.size() == 3);
  CHECK(weights[0].force_per_length.z() == Approx(-10 * pi * 0.16));
  CHECK(weights[1].force_per_length.z() == Approx(-10 * 0.12));
  CHECK(weights[1].rod == 1);
  // 0.25 kg/m: 2.5 N/m, 25 mN a cm.
  CHECK(weights[2].force_per_length.z() == Approx(-25));
  CHECK(weights[2].force_per_length.head<2>().isZero(0));
  const auto& loads = scene.structure.point_loads;
  REQUIRE(loads.size() == 1);
  CHECK(loads[0].rod == 1);
  CHECK(loads[0].s == 0.5);
  CHECK(loads[0].force == Eigen::Vector3d(1, 2, 3));
}
