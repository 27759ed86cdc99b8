// Scenes with more and fewer vertices.
#include <numbers>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/pipeline/resolution.hpp>

#include "scenes.hpp"

using namespace tencer;
using std::numbers::pi;

namespace {

io::Scene ring_and_arch() {
  Eigen::Matrix3Xd arch(3, 21);
  for (int i = 0; i <= 20; ++i) arch.col(i) << i - 10, 40 + 5 * std::sin(pi * i / 20), 0;
  return scene_of({curves::ellipse(32.5, 25, 30), {arch, false}});
}

double length(const io::SceneRod& rod) { return geometry::edge_lengths(rod.target).sum(); }

}  // namespace

TEST_CASE("rods keep their curves at another resolution") {
  const io::Scene scene = ring_and_arch();
  const double times = GENERATE(0.5, 2.0, 3.5);
  CAPTURE(times);
  const io::Scene other = pipeline::at_resolution(scene, times);
  CHECK(other.rods[0].target.vertices() == static_cast<int>(30 * times));
  CHECK(other.rods[1].target.vertices() == static_cast<int>(20 * times) + 1);
  for (int r : {0, 1}) {
    const auto& points = other.rods[r].target.points;
    const int n = other.rods[r].target.vertices();
    const Eigen::VectorXd edges = geometry::edge_lengths(other.rods[r].target);
    CHECK(edges.maxCoeff() / edges.minCoeff() < 1.02);
    CHECK(other.rods[r].weights.size() == n);
    for (int i = 0; i < n; ++i) {
      const double x = points(0, i);
      const double y = points(1, i);
      // The curves that the scene's vertices are on.
      if (r == 0)
        CHECK(std::hypot(x / 32.5, y / 25) == Approx(1).margin(2e-4));
      else
        CHECK(y == Approx(40 + 5 * std::sin(pi * (x + 10) / 20)).margin(2e-4));
    }
  }
  CHECK(
      (other.rods[1].target.points.rightCols(1) - scene.rods[1].target.points.rightCols(1)).norm() <
      1e-9);
}

TEST_CASE("what a scene says of vertices and arc lengths goes along with the resolution") {
  io::Scene scene = ring_and_arch();
  scene.planar = true;
  scene.pinned = {{.rod = 1, .vertex = 0},
                  {.rod = 1, .vertex = 1, .axes = {false, true, false}},
                  {.rod = 1, .vertex = 20},
                  {.rod = 0, .vertex = 29},
                  {.rod = 0, .vertex = 0}};
  scene.rods[0].forbidden_vertices = {15};
  scene.rods[1].forbidden_arcs = {{0, length(scene.rods[1]) / 4}};
  scene.point_loads = {{.rod = 1, .s = length(scene.rods[1]), .force = {0, -1, 0}}};
  scene.rods[0].weights.tail(15).setConstant(3);

  const io::Scene finer = pipeline::at_resolution(scene, 3);
  const auto axes_at = [&](int rod, int vertex) {
    std::array<bool, 3> axes{};
    for (const auto& pin : finer.pinned)
      if (pin.rod == rod && pin.vertex == vertex) axes = pin.axes;
    return axes;
  };
  using Axes = std::array<bool, 3>;
  // The two edges that were held at both ends, one of them across the seam, and the ends.
  CHECK(finer.pinned.size() == 4 + 5);
  for (int v : {87, 88, 89, 0}) CHECK(axes_at(0, v) == Axes{true, true, true});
  for (int v : {0, 60}) CHECK(axes_at(1, v) == Axes{true, true, true});
  for (int v : {1, 2, 3}) CHECK(axes_at(1, v) == Axes{false, true, false});

  CHECK(finer.rods[0].forbidden_vertices.empty());
  REQUIRE(finer.rods[0].forbidden_arcs.size() == 1);
  CHECK(finer.rods[0].forbidden_arcs[0].from == Approx(length(finer.rods[0]) / 2).epsilon(1e-3));
  CHECK(finer.rods[0].forbidden_arcs[0].from == finer.rods[0].forbidden_arcs[0].to);
  CHECK(finer.rods[1].forbidden_arcs[0].to == Approx(length(finer.rods[1]) / 4));
  CHECK(finer.point_loads[0].s == Approx(length(finer.rods[1])));
  CHECK(finer.rods[0].weights.size() == 90);
  CHECK(finer.rods[0].weights.head(40).isConstant(1));
  CHECK(finer.rods[0].weights.tail(45).head(40).isConstant(3));
  CHECK((finer.rods[0].target.points.row(2).array() == scene.rods[0].target.points(2, 0)).all());
  CHECK(pipeline::prepare(finer));
}

TEST_CASE("a resolution keeps enough vertices, and a factor of 1 changes nothing") {
  const io::Scene scene = ring_and_arch();
  const io::Scene coarse = pipeline::at_resolution(scene, 1e-3);
  CHECK(coarse.rods[0].target.vertices() == 3);
  CHECK(coarse.rods[1].target.vertices() == 3);
  CHECK(pipeline::at_resolution(scene, 1).rods[0].target.points == scene.rods[0].target.points);
  CHECK_THROWS_AS(pipeline::at_resolution(scene, 0), std::invalid_argument);
}

TEST_CASE("a rod bent at rest is bent as much at another resolution") {
  io::Scene scene = ring_and_arch();
  scene.rods[0].rest.curvature = 0.02;
  scene.rods[1].rest.curve = scene.rods[1].target;
  for (double times : {0.5, 2.0}) {
    const auto prepared = prepared_of(pipeline::at_resolution(scene, times));
    CHECK(prepared.file.rods[0].rest_curvature.row(0).sum() ==
          Approx(0.02 * length(scene.rods[0])).epsilon(0.01));
    // The arch's turn between its ends.
    CHECK(prepared.file.rods[1].rest_curvature.colwise().norm().sum() ==
          Approx(2 * std::atan(5 * pi / 20)).epsilon(0.05));
  }
}
