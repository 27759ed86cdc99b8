#include <catch2/catch.hpp>
#include <tencer/geometry/braid.hpp>
#include <tencer/geometry/families.hpp>
#include <tencer/geometry/knots.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/geometry/repulsion.hpp>
#include <tencer/geometry/sampling.hpp>
#include <tencer/geometry/tangent_point.hpp>

#include "knot_type.hpp"

using namespace tencer;
using namespace tencer::geometry;
using std::numbers::pi;

namespace {

// Coefficients of the Alexander and Jones polynomials, lowest power first, as in Rolfsen's table;
// the Jones polynomial's up to its lowest power and the mirror image.
struct Known {
  std::string_view name;
  std::vector<int> alexander;
  std::vector<int> jones;
};

const std::vector<Known> table = {
    {"3_1", {1, -1, 1}, {1, 0, 1, -1}},
    {"4_1", {1, -3, 1}, {1, -1, 1, -1, 1}},
    {"5_1", {1, -1, 1, -1, 1}, {1, 0, 1, -1, 1, -1}},
    {"5_2", {2, -3, 2}, {1, -1, 2, -1, 1, -1}},
    {"6_1", {2, -5, 2}, {1, -1, 2, -2, 1, -1, 1}},
    {"6_2", {1, -3, 3, -3, 1}, {1, -1, 2, -2, 2, -2, 1}},
    {"6_3", {1, -3, 5, -3, 1}, {-1, 2, -2, 3, -2, 2, -1}},
    {"7_1", {1, -1, 1, -1, 1, -1, 1}, {1, 0, 1, -1, 1, -1, 1, -1}},
    {"7_2", {3, -5, 3}, {1, -1, 2, -2, 2, -1, 1, -1}},
    {"7_3", {2, -3, 3, -3, 2}, {1, -1, 2, -2, 3, -2, 1, -1}},
    {"7_4", {4, -7, 4}, {1, -2, 3, -2, 3, -2, 1, -1}},
    {"7_5", {2, -4, 5, -4, 2}, {1, -1, 3, -3, 3, -3, 2, -1}},
    {"7_6", {1, -5, 7, -5, 1}, {1, -2, 3, -3, 4, -3, 2, -1}},
    {"7_7", {1, -5, 9, -5, 1}, {-1, 3, -3, 4, -4, 3, -2, 1}},
};

double modulus(const std::vector<int>& polynomial, double angle) {
  std::complex<double> sum = 0;
  for (std::size_t k = 0; k < polynomial.size(); ++k)
    sum += static_cast<double>(polynomial[k]) * std::polar(1.0, static_cast<double>(k) * angle);
  return std::abs(sum);
}

// The shadow with the fewest crossings of those from many directions.
std::vector<Crossing> simplest_shadow(const Polyline& curve) {
  constexpr int directions = 200;
  auto best = crossings(curve, direction(0, directions));
  for (int i = 1; i < directions; ++i) {
    auto shadow = crossings(curve, direction(i, directions));
    if (shadow.size() < best.size()) best = std::move(shadow);
  }
  return best;
}

// On the unit circle the values at more angles than there are coefficients determine a palindromic
// polynomial but for its sign.
const std::vector<double> angles = {0.3, 0.7, 1.1, 1.5, 1.9, 2.3, 2.7, pi};

bool is_knot(const std::vector<Crossing>& shadow, const Known& known) {
  return std::ranges::all_of(angles, [&](double angle) {
    return std::abs(alexander(shadow, angle) - modulus(known.alexander, angle)) < 1e-9 &&
           std::abs(jones(shadow, angle) - modulus(known.jones, angle)) < 1e-9;
  });
}

Polyline unknot(int n) {
  Polyline curve{Eigen::Matrix3Xd(3, n), true};
  for (int i = 0; i < n; ++i) {
    const double t = 2 * pi * i / n;
    curve.points.col(i) << std::cos(t) + 0.5 * std::cos(2 * t), std::sin(t), 0.4 * std::sin(3 * t);
  }
  return curve;
}

}  // namespace

TEST_CASE("the tables tell the knots apart") {
  // Each knot is matched by itself only, so is_knot below says which knot a curve is.
  for (const Known& one : table)
    for (const Known& other : table) {
      double difference = 0;
      for (const double angle : angles)
        difference = std::max(
            difference, std::abs(modulus(one.alexander, angle) - modulus(other.alexander, angle)));
      CHECK((difference > 0.01) == (one.name != other.name));
    }
}

TEST_CASE("knots of the table have the published Alexander and Jones polynomials") {
  const auto braids = knot_table();
  REQUIRE(braids.size() == table.size());
  for (std::size_t k = 0; k < table.size(); ++k) {
    const Known& known = table[k];
    CAPTURE(known.name);
    REQUIRE(braids[k].name == known.name);
    CHECK(is_knot(simplest_shadow(braid_closure(braids[k].strands, braids[k].word)), known));

    const Polyline curve = knot(braids[k], 300, 160);
    const auto shadow = simplest_shadow(curve);
    CHECK(is_knot(shadow, known));
    CHECK(shadow.size() <= 9);

    // Evenly spaced, smooth and roomy: a rope as thick as 1/100 of its length fits.
    REQUIRE(curve.vertices() == 160);
    const Eigen::VectorXd lengths = edge_lengths(curve);
    CHECK(lengths.sum() == Approx(300).epsilon(0.005));
    CHECK(lengths.maxCoeff() / lengths.minCoeff() < 1.02);
    CHECK(thickness(curve) > lengths.sum() / 100);
  }
}

TEST_CASE("a knot's shape does not depend on its size or its vertices") {
  const KnotBraid trefoil = knot_table()[0];
  const Polyline coarse = knot(trefoil, 1, 50);
  const Polyline fine = knot(trefoil, 10, 100);
  double worst = 0;
  for (int i = 0; i < 50; ++i)
    worst = std::max(worst, (10 * coarse.points.col(i) - fine.points.col(2 * i)).norm());
  CHECK(worst < 1e-6);
}

TEST_CASE("knots are families, too") {
  const auto known = families();
  const auto family = std::ranges::find(known, "knot-4_1", &Family::name);
  REQUIRE(family != known.end());
  const std::vector<double> values{120};
  const auto curves = family_curves(*family, values, 90);
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].points == knot(knot_table()[1], 120, 90).points);
}

TEST_CASE("a braid closure goes round once a strand") {
  const Polyline curve = braid_closure(3, std::vector<int>{1, 2});
  double turns = 0;
  for (int i = 0; i < curve.vertices(); ++i) {
    const Eigen::Vector3d a = curve.points.col(i), b = curve.points.col((i + 1) % curve.vertices());
    turns += std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y()) / (2 * pi);
  }
  CHECK(turns == Approx(3));
  const auto closed = [](int strands, std::vector<int> word) { braid_closure(strands, word); };
  CHECK_THROWS_AS(closed(2, {1, 1}), std::invalid_argument);  // two curves
  CHECK_THROWS_AS(closed(3, {1, 3}), std::invalid_argument);
  CHECK_THROWS_AS(closed(3, {0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(closed(1, {}), std::invalid_argument);
}

TEST_CASE("gradient of the tangent-point energy") {
  const Polyline curve = unknot(24);
  const TangentPoint at = tangent_point_energy(curve);
  const double h = 1e-6;
  for (int i = 0; i < 24; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      Polyline plus = curve, minus = curve;
      plus.points(axis, i) += h;
      minus.points(axis, i) -= h;
      const double difference =
          (tangent_point_energy(plus).energy - tangent_point_energy(minus).energy) / (2 * h);
      CHECK(at.gradient(axis, i) == Approx(difference).epsilon(1e-6).margin(1e-5));
    }
}

TEST_CASE("tangent-point energy and thickness of a circle") {
  // Every circle tangent to it that meets it again is the circle itself, |T x d| / |d|^2 = 1 /
  // (2R): the energy is L (2 pi R)^2 / (2R)^3.
  Polyline circle{Eigen::Matrix3Xd(3, 1000), true};
  for (int i = 0; i < 1000; ++i)
    circle.points.col(i) << 5 * std::cos(2 * pi * i / 1000), 5 * std::sin(2 * pi * i / 1000), 1;
  CHECK(tangent_point_energy(circle).energy == Approx(pi * pi * pi).epsilon(2e-3));
  CHECK(thickness(circle) == Approx(5).epsilon(1e-4));
}

TEST_CASE("an unknot comes to rest as a circle") {
  const Repelled rest = repel(unknot(60));
  CHECK(rest.converged);
  CHECK(rest.energy == Approx(tangent_point_energy(rest.curve).energy).epsilon(1e-12));
  CHECK(edge_lengths(rest.curve).sum() == Approx(1));
  const Eigen::RowVectorXd radii = rest.curve.points.colwise().norm();
  CHECK(radii.maxCoeff() / radii.minCoeff() < 1.02);
}

TEST_CASE("repulsion does not start from a curve that crosses itself") {
  Polyline eight{Eigen::Matrix3Xd(3, 16), true};
  for (int i = 0; i < 16; ++i) eight.points.col(i) << std::sin(pi * i / 8), std::sin(pi * i / 4), 0;
  CHECK_THROWS_AS(repel(eight), std::invalid_argument);
}
