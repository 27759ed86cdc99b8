#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "figures.hpp"
#include "fixtures/cube.hpp"

namespace tencer::symmetry {
namespace {

using std::numbers::pi;

// Every operation maps points of the figure onto the points it says, to the relative tolerance.
void check_operations(const Figure& figure, const Symmetry& symmetry, double tolerance) {
  const double allowed = tolerance * 10.0;  // in the figures' units: about ten across
  for (const Operation& operation : symmetry.group.operations) {
    REQUIRE((operation.matrix.transpose() * operation.matrix - Eigen::Matrix3d::Identity()).norm() <
            1e-13);
    for (int r = 0; r < static_cast<int>(figure.rods.size()); ++r) {
      for (int k = 0; k < 50; ++k) {
        const springs::End end = springs::OnRod{r, figure.rods[r].length() * k / 50.0};
        const Eigen::Vector3d moved = operation.matrix * point(figure, end) + operation.translation;
        REQUIRE((moved - point(figure, image(operation, end, figure.rods))).norm() < allowed);
      }
    }
    for (int i = 0; i < static_cast<int>(operation.anchors.size()); ++i)
      REQUIRE((operation.matrix * figure.anchors.col(i) + operation.translation -
               figure.anchors.col(operation.anchors[i]))
                  .norm() < allowed);
  }
}

Figure moved(Figure figure) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const Eigen::Vector3d shift(300, -20, 55);
  for (geometry::Polyline& curve : figure.curves)
    curve.points = (turn * curve.points).colwise() + shift;
  figure.anchors = (turn * figure.anchors).colwise() + shift;
  return figure;
}

geometry::Polyline straight(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int vertices) {
  geometry::Polyline line{Eigen::Matrix3Xd(3, vertices), false};
  for (int i = 0; i < vertices; ++i) line.points.col(i) = from + (to - from) * i / (vertices - 1.0);
  return line;
}

}  // namespace

TEST_CASE("a trefoil has one 3-fold and three 2-fold axes, whatever its number of vertices") {
  for (const int vertices : {60, 99, 100, 101, 102, 257, 600}) {
    const Figure figure = moved(trefoil(vertices));
    const Symmetry found = detect(figure);
    INFO(vertices);
    CHECK(found.group.order() == 6);
    CHECK(axes(found, 3) == 1);
    CHECK(axes(found, 2) == 3);
    CHECK(planes(found) == 0);
    CHECK(found.misfit < 1e-4);
    check_operations(figure, found, 1e-3);
  }
}

TEST_CASE("where vertices fall onto vertices the fit is exact") {
  const Figure figure = trefoil(102);
  const Symmetry found = detect(figure);
  REQUIRE(found.group.order() == 6);
  CHECK(found.misfit < 1e-7);
  check_operations(figure, found, 1e-7);
}

TEST_CASE("torus knots have the axes of their windings") {
  const Symmetry five_three = detect(figure_of({curves::torus_knot(5, 3, 3.0, 1.0, 200)}));
  CHECK(five_three.group.order() == 6);
  CHECK(axes(five_three, 3) == 1);
  CHECK(axes(five_three, 2) == 3);
  CHECK(planes(five_three) == 0);
  const Symmetry three_five = detect(figure_of({curves::torus_knot(3, 5, 3.0, 1.0, 301)}));
  CHECK(three_five.group.order() == 10);
  CHECK(axes(three_five, 5) == 1);
  CHECK(axes(three_five, 2) == 5);
}

TEST_CASE("two interleaved trefoils share a 6-fold axis") {
  const Figure figure = figure_of(curves::twin_trefoils(3.0, 1.2, 101));
  const Symmetry found = detect(figure);
  CHECK(found.group.order() == 12);
  CHECK(axes(found, 6) == 1);
  CHECK(axes(found, 2) == 6);
  CHECK(planes(found) == 0);
  check_operations(figure, found, 1e-3);
}

TEST_CASE("three Borromean ellipses have the pyritohedral group") {
  const Figure figure = moved(figure_of(curves::borromean_ellipses(5.0, 3.0, 98)));
  const Symmetry found = detect(figure);
  CHECK(found.group.order() == 24);
  CHECK(axes(found, 3) == 4);
  CHECK(axes(found, 2) == 3);
  CHECK(planes(found) == 3);
  check_operations(figure, found, 1e-3);
}

TEST_CASE("only alike rods go to each other") {
  Figure figure = figure_of(curves::borromean_ellipses(5.0, 3.0, 100));
  figure.classes = {0, 0, 7};
  const Symmetry found = detect(figure);
  CHECK(found.group.order() == 8);
  CHECK(axes(found, 3) == 0);
  CHECK(axes(found, 2) == 3);
  CHECK(planes(found) == 3);
}

TEST_CASE("a regular polygon has its own group, and one of many vertices that of a circle") {
  const Symmetry octagon = detect(figure_of({curves::circle(4.0, 8)}));
  CHECK(octagon.group.order() == 32);
  CHECK(axes(octagon, 8) == 1);
  CHECK(axes(octagon, 2) == 8);
  CHECK(planes(octagon) == 9);
  CHECK(octagon.misfit < 1e-7);
  const Figure figure = moved(figure_of({curves::circle(4.0, 100)}));
  const Symmetry circle = detect(figure);
  CHECK(circle.group.order() == 48);
  CHECK(axes(circle, 12) == 1);
  check_operations(figure, circle, 1e-3);
  CHECK(axes(detect(figure, {.continuous_fold = 5}), 5) == 1);
}

TEST_CASE("circles about different axes through one point") {
  // Rings of a gimbal: each is round, together they have three 2-fold axes and three mirrors.
  std::vector<geometry::Polyline> rings;
  for (int i = 0; i < 3; ++i) {
    geometry::Polyline ring = curves::circle(5.0 - i, 150);
    const geometry::Polyline original = ring;
    for (int axis = 0; axis < 3; ++axis)
      ring.points.row((axis + i) % 3) = original.points.row(axis);
    rings.push_back(ring);
  }
  const Figure figure = moved(figure_of(rings));
  const Symmetry found = detect(figure);
  CHECK(found.group.order() == 8);
  CHECK(axes(found, 2) == 3);
  CHECK(planes(found) == 3);
  check_operations(figure, found, 1e-3);
}

TEST_CASE("a round figure takes the symmetry of its anchors") {
  Figure ring = figure_of({curves::circle(4.0, 120)});
  ring.anchors = cube(5.0);
  const Symmetry found = detect(moved(ring));
  CHECK(found.group.order() == 16);
  CHECK(axes(found, 4) == 1);
  CHECK(axes(found, 2) == 4);
  CHECK(planes(found) == 5);
  Figure line = figure_of({straight({0, 0, -4}, {0, 0, 4}, 30)});
  CHECK(detect(line).group.order() == 4);
  line.anchors = cube(5.0);
  CHECK(detect(moved(line)).group.order() == 16);
}

TEST_CASE("a random closed curve has no symmetry") {
  std::mt19937 random(3);
  for (int trial = 0; trial < 10; ++trial) {
    const Symmetry found = detect(figure_of({random_curve(random, 150)}));
    CHECK(found.group.order() == 1);
    CHECK(found.elements.empty());
  }
}

TEST_CASE("an open helix has one 2-fold axis, with a cube of anchors only if these fit") {
  Figure helix = figure_of({curves::helix(8.0, 2.0, 3.25, 100)});
  const Symmetry found = detect(moved(helix));
  CHECK(found.group.order() == 2);
  CHECK(axes(found, 2) == 1);
  check_operations(helix, detect(helix), 1e-6);
  // A slanting box about the same centre.
  helix.anchors = cube(6.0);
  helix.anchors.row(0) += 0.3 * helix.anchors.row(1);
  CHECK(detect(helix).group.order() == 1);
}

TEST_CASE("a mirrored pair of random curves has one mirror plane") {
  std::mt19937 random(5);
  const geometry::Polyline left = random_curve(random, 140);
  geometry::Polyline right = left;
  right.points.row(0) *= -1.0;
  right.points.row(0).array() += 15.0;
  // Another start and the other direction, which the map of arc lengths has to find.
  right = geometry::resample(right, 140);
  const Eigen::Matrix3Xd points = right.points;
  for (int i = 0; i < 140; ++i) right.points.col(i) = points.col((200 - i) % 140);
  const Figure figure = figure_of({left, right});
  const Symmetry found = detect(figure);
  REQUIRE(found.group.order() == 2);
  CHECK(planes(found) == 1);
  CHECK(std::abs(std::get<Reflection>(found.elements[0]).normal.x()) == Approx(1.0).epsilon(1e-6));
  CHECK(found.group.operations[1].rods[0].rod == 1);
  CHECK(found.group.operations[1].rods[0].rate < 0.0);
  check_operations(figure, found, 1e-3);
}

TEST_CASE("the tolerance decides") {
  Figure figure = trefoil(100);
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0.0, 0.005);
  for (int i = 0; i < 100; ++i)
    for (int axis = 0; axis < 3; ++axis) figure.curves[0].points(axis, i) += noise(random);
  // Three deviations of the difference of two such points, over a diagonal of about 11.
  CHECK(detect(figure, {.tolerance = 1e-2}).group.order() == 6);
  CHECK(detect(figure, {.tolerance = 1e-4}).group.order() == 1);
}

TEST_CASE("detected groups obey their multiplication table to rounding") {
  Figure figure = trefoil(100);
  std::mt19937 random(12);
  std::normal_distribution<double> noise(0.0, 0.005);
  for (int i = 0; i < 100; ++i)
    for (int axis = 0; axis < 3; ++axis) figure.curves[0].points(axis, i) += noise(random);
  const Group group = detect(figure, {.tolerance = 1e-2}).group;
  REQUIRE(group.order() == 6);
  for (int g = 0; g < 6; ++g) {
    for (int h = 0; h < 6; ++h) {
      const Operation product = compose(group.operations[g], group.operations[h], group.rods);
      const Operation& stored = group.operations[group.product(g, h)];
      CHECK((product.matrix - stored.matrix).norm() < 1e-13);
      CHECK((product.translation - stored.translation).norm() < 1e-11);
      CHECK(std::abs(std::remainder(product.rods[0].offset - stored.rods[0].offset,
                                    group.rods[0].length())) < 1e-11);
      CHECK(product.rods[0].rate == stored.rods[0].rate);
    }
  }
}

TEST_CASE("arc length at rest is what counts") {
  // The curve is a circle, but the rod is unevenly long at rest: only one mirror and the plane keep
  // rest lengths.
  Figure figure = figure_of({curves::circle(4.0, 120)});
  Eigen::VectorXd rest = geometry::edge_lengths(figure.curves[0]);
  for (int i = 0; i < 120; ++i) rest[i] *= 1.0 + 0.2 * std::cos(2.0 * pi * (i + 0.5) / 120);
  figure.rods[0] = geometry::ArcLength(rest, true);
  const Symmetry found = detect(figure);
  CHECK(found.group.order() == 4);
  CHECK(planes(found) == 2);
  CHECK(axes(found, 2) == 1);
}

TEST_CASE("given generators are checked and completed") {
  const Figure figure = trefoil(100);
  const auto rotations = verify(figure, std::vector<model::SymmetryGenerator>{Rotation{.fold = 3}});
  REQUIRE(rotations);
  CHECK(rotations->group.order() == 3);
  const auto all = verify(
      figure, std::vector<model::SymmetryGenerator>{
                  Rotation{.fold = 3}, Rotation{.fold = 2, .axis = Eigen::Vector3d::UnitY()}});
  REQUIRE(all);
  CHECK(all->group.order() == 6);
  check_operations(figure, *all, 1e-3);

  const auto none = verify(figure, {});
  REQUIRE(none);
  CHECK(none->group.order() == 1);
}

TEST_CASE("generators given for a figure away from the origin") {
  Figure figure = figure_of({curves::torus_knot(5, 3, 3.0, 1.0, 201)});
  figure.curves[0].points.row(0).array() += 1e4;
  const auto found =
      verify(figure, std::vector<model::SymmetryGenerator>{Rotation{
                         .fold = 3, .axis = {0, 0, 2}, .point = Eigen::Vector3d(1e4, 0, 7)}});
  REQUIRE(found);
  CHECK(found->group.order() == 3);
  CHECK(found->misfit < 1e-6);
  // Through the centroid when no point is given.
  const auto central = verify(figure, std::vector<model::SymmetryGenerator>{Rotation{.fold = 3}});
  REQUIRE(central);
  CHECK(central->group.order() == 3);
}

TEST_CASE("a generator that misses says by how much") {
  const Figure figure = trefoil(100);
  const auto missed =
      verify(figure, std::vector<model::SymmetryGenerator>{
                         Rotation{.fold = 3}, Reflection{.normal = Eigen::Vector3d::UnitZ()}});
  REQUIRE_FALSE(missed);
  CHECK(missed.error().where == "symmetry[1]");
  CHECK_THAT(missed.error().message, Catch::Contains("the reflection with normal (0, 0, 1)") &&
                                         Catch::Contains("the rod misses") &&
                                         Catch::Contains("where 0.1 % is allowed"));
  Figure anchored = trefoil(102);
  anchored.anchors = Eigen::Vector3d(20, 1, 0);
  const auto anchor = verify(anchored, std::vector<model::SymmetryGenerator>{Rotation{.fold = 3}});
  REQUIRE_FALSE(anchor);
  CHECK_THAT(anchor.error().message, Catch::Contains("anchor 1 misses"));
}

TEST_CASE("generators that belong to no finite group are refused") {
  // Each fits a large polygon's circle, the two axes cross at an angle of no finite group.
  const Figure figure = figure_of({curves::circle(4.0, 600)});
  const double angle = 1.0;
  const auto found =
      verify(figure, std::vector<model::SymmetryGenerator>{
                         Reflection{.normal = {1, 0, 0}},
                         Reflection{.normal = {std::cos(angle), std::sin(angle), 0}}});
  REQUIRE_FALSE(found);
  CHECK(found.error().where == "symmetry");
  CHECK_THAT(found.error().message, Catch::Contains("more than 240"));
}

TEST_CASE("figures whose parts do not fit are refused") {
  Figure figure = trefoil(50);
  figure.classes = {1, 2};
  CHECK_THROWS_AS(detect(figure), std::invalid_argument);
  CHECK_THROWS_AS(detect(Figure{}), std::invalid_argument);
  CHECK_THROWS_AS(detect(trefoil(50), {.tolerance = 0.0}), std::invalid_argument);
  CHECK_THROWS_AS(verify(trefoil(50), std::vector<model::SymmetryGenerator>{Rotation{.fold = 1}}),
                  std::invalid_argument);
}

}  // namespace tencer::symmetry
