#include <algorithm>
#include <catch2/catch.hpp>
#include <tencer/curves/braid.hpp>
#include <tencer/curves/families.hpp>
#include <tencer/curves/knots.hpp>

#include "knot_type.hpp"
#include "thickness.hpp"

using namespace tencer;
using namespace tencer::curves;
using geometry::Polyline;
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
    CHECK(test::thickness(curve) > lengths.sum() / 100);
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
