// Scenes with more and fewer vertices.
#include <catch2/catch.hpp>
#include <numbers>
#include <tencer/curves/analytic.hpp>
#include <tencer/model/resolution.hpp>
#include <tencer/model/rest_shape.hpp>

using namespace tencer;
using std::numbers::pi;

namespace {

model::Scene ring_and_arch() {
  Eigen::Matrix3Xd arch(3, 21);
  for (int i = 0; i <= 20; ++i) arch.col(i) << i - 10, 40 + 5 * std::sin(pi * i / 20), 0;
  return model::scene_of({curves::ellipse(32.5, 25, 30), {arch, false}});
}

}  // namespace

TEST_CASE("rods keep their curves at another resolution") {
  const model::Scene scene = ring_and_arch();
  const double times = GENERATE(0.5, 2.0, 3.5);
  CAPTURE(times);
  const model::Scene other = model::at_resolution(scene, times);
  CHECK(other.target.points[0].cols() == static_cast<int>(30 * times));
  CHECK(other.target.points[1].cols() == static_cast<int>(20 * times) + 1);
  for (int r : {0, 1}) {
    const Eigen::Matrix3Xd& points = other.target.points[r];
    const Eigen::VectorXd edges = geometry::edge_lengths(target_curve(other, r));
    CHECK(edges.maxCoeff() / edges.minCoeff() < 1.02);
    CHECK(other.structure.rods[r].rest_lengths == edges);
    CHECK(other.target.weights[r].size() == points.cols());
    for (int i = 0; i < points.cols(); ++i) {
      const double x = points(0, i);
      const double y = points(1, i);
      // The curves that the scene's vertices are on.
      if (r == 0)
        CHECK(std::hypot(x / 32.5, y / 25) == Approx(1).margin(2e-4));
      else
        CHECK(y == Approx(40 + 5 * std::sin(pi * (x + 10) / 20)).margin(2e-4));
    }
  }
  CHECK((other.target.points[1].rightCols(1) - scene.target.points[1].rightCols(1)).norm() < 1e-9);
}

TEST_CASE("what a scene says of vertices and arc lengths goes along with the resolution") {
  model::Scene scene = ring_and_arch();
  const double length = scene.structure.rods[1].length();
  scene.structure.planar = true;
  scene.structure.pins = {{.rod = 1, .vertex = 0},
                          {.rod = 1, .vertex = 1, .axes = {false, true, false}},
                          {.rod = 1, .vertex = 20},
                          {.rod = 0, .vertex = 29},
                          {.rod = 0, .vertex = 0}};
  const double halfway = arc_lengths(scene.structure)[0].knots()[15];
  scene.rules.forbidden = {{.rod = 0, .from = halfway, .to = halfway},
                           {.rod = 1, .from = 0, .to = length / 4}};
  scene.structure.point_loads = {{.rod = 1, .s = length, .force = {0, -1, 0}}};
  scene.target.weights[0].tail(15).setConstant(3);

  const model::Scene finer = model::at_resolution(scene, 3);
  const model::Structure& structure = finer.structure;
  const auto axes_at = [&](int rod, int vertex) {
    std::array<bool, 3> axes{};
    for (const auto& pin : structure.pins)
      if (pin.rod == rod && pin.vertex == vertex) axes = pin.axes;
    return axes;
  };
  using Axes = std::array<bool, 3>;
  // The two edges that were held at both ends, one of them across the seam, and the ends.
  CHECK(structure.pins.size() == 4 + 5);
  for (int v : {87, 88, 89, 0}) CHECK(axes_at(0, v) == Axes{true, true, true});
  for (int v : {0, 60}) CHECK(axes_at(1, v) == Axes{true, true, true});
  for (int v : {1, 2, 3}) CHECK(axes_at(1, v) == Axes{false, true, false});

  REQUIRE(finer.rules.forbidden.size() == 2);
  const auto& place = finer.rules.forbidden[0];
  CHECK(place.from == Approx(structure.rods[0].length() / 2).epsilon(1e-3));
  CHECK(place.from == place.to);
  CHECK(finer.rules.forbidden[1].to == Approx(structure.rods[1].length() / 4));
  CHECK(structure.point_loads[0].s == Approx(structure.rods[1].length()));
  CHECK(finer.target.weights[0].size() == 90);
  CHECK(finer.target.weights[0].head(40).isConstant(1));
  CHECK(finer.target.weights[0].tail(45).head(40).isConstant(3));
  CHECK((finer.target.points[0].row(2).array() == scene.target.points[0](2, 0)).all());
  CHECK_NOTHROW(validate(structure));
  CHECK_NOTHROW(validate(finer.target, structure));
  CHECK_NOTHROW(validate(finer.rules, structure));
}

TEST_CASE("a resolution keeps enough vertices, and a factor of 1 changes nothing") {
  const model::Scene scene = ring_and_arch();
  const model::Scene coarse = model::at_resolution(scene, 1e-3);
  CHECK(coarse.structure.rods[0].vertices() == 3);
  CHECK(coarse.structure.rods[1].vertices() == 3);
  CHECK(model::at_resolution(scene, 1).target.points == scene.target.points);
  CHECK_THROWS_AS(model::at_resolution(scene, 0), std::invalid_argument);
}

TEST_CASE("a rod bent at rest is bent as much at another resolution") {
  model::Scene scene = ring_and_arch();
  auto& rods = scene.structure.rods;
  model::set_rest_shape({.curvature = 0.02}, rods[0]);
  model::set_rest_shape({.curve = target_curve(scene, 1)}, rods[1]);
  for (double times : {0.5, 2.0}) {
    const model::Scene other = model::at_resolution(scene, times);
    CHECK(other.structure.rods[0].rest_curvature.row(0).sum() ==
          Approx(0.02 * rods[0].length()).epsilon(0.01));
    // The arch's turn between its ends.
    CHECK(other.structure.rods[1].rest_curvature.colwise().norm().sum() ==
          Approx(2 * std::atan(5 * pi / 20)).epsilon(0.05));
  }
}

TEST_CASE("each rod may have a resolution of its own") {
  const model::Scene scene = ring_and_arch();
  const model::Scene other = model::at_resolution(scene, std::vector<double>{1, 2});
  CHECK(other.target.points[0] == scene.target.points[0]);
  CHECK(other.structure.rods[1].edges() == 40);
  CHECK_THROWS_AS(model::at_resolution(scene, std::vector<double>{1}), std::invalid_argument);
  CHECK_THROWS_AS(model::at_resolution(scene, std::vector<double>{1, -1}), std::invalid_argument);
}

TEST_CASE("a rod has as many vertices as its bends need, which follow the same curve") {
  const geometry::Polyline ellipse = curves::ellipse(32.5, 25, 20000);
  model::Scene scene = model::scene_of({ellipse, curves::ellipse(2, 1, 30)});
  const model::Scene enough = model::with_enough_vertices(scene);
  CHECK(enough.structure.rods[0].edges() == 1000);
  CHECK(enough.structure.rods[1].edges() == 30);
  REQUIRE(enough.notes.size() == scene.notes.size() + 1);
  CHECK(enough.notes.back().find("rod A with 1000 edges in place of 20000") != std::string::npos);
  for (const auto& point : enough.target.points[0].colwise())
    CHECK(std::pow(point.x() / 32.5, 2) + std::pow(point.y() / 25, 2) == Approx(1).epsilon(1e-9));

  // Many windings need more; what is not far above that stays as it is.
  Eigen::Matrix3Xd coil(3, 20000);
  for (int i = 0; i < coil.cols(); ++i) {
    const double angle = 40 * 2 * pi * i / 19999;
    coil.col(i) << std::cos(angle), std::sin(angle), 0.1 * angle;
  }
  scene = model::scene_of({{coil, false}});
  CHECK(model::with_enough_vertices(scene).structure.rods[0].edges() ==
        Approx(40 * 2 * pi / 0.03).epsilon(0.01));
  scene = model::scene_of({curves::ellipse(32.5, 25, 1900)});
  CHECK(model::with_enough_vertices(scene).structure.rods[0].edges() == 1900);
}
